#!/usr/bin/env python
"""Do settings.ini, which pip has our names from, `[tool.nbdev]` of pyproject.toml, `nbs/_quarto.yml` and the package agree?
What differs is printed; the exit status is 1 then."""
import re, sys
from pathlib import Path

import yaml
try: import tomllib
except ImportError: import tomli as tomllib

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests import settings


def differences(ours, table, site, version):
    "One sentence for each value of settings.ini, `ours`, that stands somewhere else, too, and differs there"
    for key in sorted({*ours} & {*table}):
        if ours[key] != str(table[key]): yield f'settings.ini has {key} = {ours[key]}, pyproject.toml {table[key]}'
    website = site['website']
    pairs = [('title', website['title']), ('description', website['description']), ('git_url', website['repo-url']),
             ('branch', website['repo-branch'])]
    for key,there in pairs:
        if ours[key] != there: yield f'settings.ini has {key} = {ours[key]}, nbs/_quarto.yml {there}'
    address = ours['doc_host']+ours['doc_baseurl']
    if address != website['site-url']: yield f'settings.ini has the site at {address}, nbs/_quarto.yml at {website["site-url"]}'
    if site['project']['output-dir'] != table['doc_path']:
        yield f'pyproject.toml has doc_path = {table["doc_path"]}, nbs/_quarto.yml {site["project"]["output-dir"]}'
    if ours['version'] != version: yield f'settings.ini has version = {ours["version"]}, UAV/__init__.py {version}'


def main():
    top = Path(__file__).parents[1]
    table = tomllib.loads((top/'pyproject.toml').read_text(encoding='utf-8'))['tool']['nbdev']
    site = yaml.safe_load((top/'nbs/_quarto.yml').read_text(encoding='utf-8'))
    version = re.search('^__version__ = "(.*)"$', (top/'UAV/__init__.py').read_text(encoding='utf-8'), re.M)[1]
    found = list(differences(settings(), table, site, version))
    print(*(found or ['settings.ini, pyproject.toml, nbs/_quarto.yml and the package agree']), sep='\n')
    return bool(found)


if __name__ == '__main__': sys.exit(main())
