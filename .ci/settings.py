#!/usr/bin/env python
"""Do settings.ini, which pip has our names from, `[tool.nbdev]` of pyproject.toml, both `_quarto.yml` and the package agree, and are
the files there that `_quarto.yml` names? What is wrong is printed; the exit status is 1 then."""
import re, sys
from pathlib import Path

import yaml
try: import tomllib
except ImportError: import tomli as tomllib

TOP = Path(__file__).parents[1]
sys.path.insert(0, str(TOP))
from tests import settings


def read(file): return (TOP/file).read_text(encoding='utf-8')


def findings():
    "One sentence for each value of settings.ini that stands somewhere else, too, and differs there; and for each missing file"
    ours,table = settings(),tomllib.loads(read('pyproject.toml'))['tool']['nbdev']
    site,bar = yaml.safe_load(read('nbs/_quarto.yml')),yaml.safe_load(read('_quarto.yml'))['website']['navbar']
    website = site['website']
    pairs = [(key, ours[key], str(table[key]), 'pyproject.toml') for key in sorted({*ours} & {*table})]
    pairs += [('title', ours['title'], website['title'], 'nbs/_quarto.yml'),
              ('description', ours['description'], website['description'], 'nbs/_quarto.yml'),
              ('git_url', ours['git_url'], website['repo-url'], 'nbs/_quarto.yml'),
              ('git_url', ours['git_url'], bar['right'][0]['href'], 'the bar of _quarto.yml'),
              ('branch', ours['branch'], website['repo-branch'], 'nbs/_quarto.yml'),
              ('doc_host and doc_baseurl', ours['doc_host']+ours['doc_baseurl'], website['site-url'], 'nbs/_quarto.yml'),
              ('doc_path', table['doc_path'], site['project']['output-dir'], 'nbs/_quarto.yml'),
              ('version', ours['version'], re.search('^__version__ = "(.*)"$', read('UAV/__init__.py'), re.M)[1], 'UAV/__init__.py')]
    yield from (f'{key} is {mine!r}, and {there!r} in {file}' for key,mine,there,file in pairs if mine!=there)
    named = re.findall(r'[\w./-]+\.(?:ipynb|svg|jpg|png|s?css)\b', read('_quarto.yml'))
    yield from (f'_quarto.yml names {name}, which is not there' for name in named if not (TOP/'nbs'/name).exists())


if __name__ == '__main__':
    found = list(findings())
    print(*(found or ['they agree, and all files are there']), sep='\n')
    sys.exit(bool(found))
