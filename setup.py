"""The package's metadata, read from settings.ini."""
import re, sys
from configparser import ConfigParser
from pathlib import Path
from setuptools import find_packages, setup
from setuptools.command.build_py import build_py

here = Path(__file__).parent
sys.path.insert(0, str(here))
import _stubs


class BuildWithStubs(build_py):
    "Write a stub beside each module, here or into the wheel; in the wheel `help` shows parameters, too"
    def run(self):
        super().run()
        editable = getattr(self, 'editable_mode', False)
        _stubs.write(here/'UAV', None if editable else Path(self.build_lib)/'UAV')
        if editable: return
        _stubs.explain(Path(self.build_lib)/'UAV')
        # other projects' nbdev links to our site by this file, and our nbdev leaves the addresses empty
        index = Path(self.build_lib)/'UAV'/'_modidx.py'
        addresses = {name: cfg[name] for name in ('doc_host', 'doc_baseurl', 'git_url', 'branch', 'lib_path')}
        text = index.read_text(encoding='utf-8')
        text = re.sub(r"'settings': \{.*?\}", f"'settings': {addresses}", text, count=1, flags=re.S)
        index.write_text(text, encoding='utf-8')


parser = ConfigParser(delimiters=['='])
parser.read(here/'settings.ini', encoding='utf-8')
cfg = parser['DEFAULT']

setup(
    name=cfg['lib_name'], version=cfg['version'], description=cfg['description'], keywords=cfg['keywords'],
    author=cfg['author'], author_email=cfg['author_email'], url=cfg['git_url'], license='Apache-2.0',
    long_description=(here/'README.md').read_text(encoding='utf-8'),
    long_description_content_type='text/markdown',
    # an editable install puts this folder on the path: editors look there, and `tests` lies there
    package_dir={'': '.'},
    packages=find_packages(include=['UAV', 'UAV.*']),
    package_data={'': ['py.typed'], 'UAV.cameras': ['configs/*.toml'], 'UAV.check': ['*.css'],
                  'UAV.manager': ['static/*'], 'UAV.video': ['static/*']},
    cmdclass={'build_py': BuildWithStubs}, zip_safe=False,
    python_requires='>='+cfg['min_python'],
    install_requires=cfg['requirements'].split(),
    extras_require={name: cfg[f'{name}_requirements'].split()
                    for name in ('notebook', 'gphoto2', 'uvc', 'webrtc', 'test', 'dev')},
    entry_points={'console_scripts': cfg['console_scripts'].split(),
                  'nbdev': [f"{cfg['lib_path']}={cfg['lib_path']}._modidx:d"],
                  'uav.devices': cfg['devices'].split(),
                  'uav.searches': cfg['searches'].split(),
                  'pytest11': [f"uav={cfg['lib_path']}.testing.plugin"]},
    project_urls={'Documentation': cfg['doc_host']+cfg['doc_baseurl'],
                  'Changelog': f"{cfg['git_url']}/blob/{cfg['branch']}/CHANGELOG.md",
                  'Issues': f"{cfg['git_url']}/issues"},
    classifiers=['Development Status :: 3 - Alpha', f"Intended Audience :: {cfg['audience']}",
                 'License :: OSI Approved :: Apache Software License',
                 'Operating System :: POSIX :: Linux',      # macOS and Windows are untested
                 *(f'Programming Language :: Python :: {version}' for version in ('3', '3.10', '3.11', '3.12', '3.13')),
                 'Framework :: AsyncIO', 'Framework :: Jupyter', 'Framework :: Pytest',
                 'Topic :: Multimedia :: Video :: Capture', 'Topic :: System :: Hardware', 'Typing :: Typed'],
)
