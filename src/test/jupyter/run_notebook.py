"""Runs a notebook in a fresh kernel, and writes it with its outputs: run_notebook.py NOTEBOOK FOLDER RESULT [TIMES].

Runs all cells in order in FOLDER, TIMES times. The result contains the outputs of the last run.
"""
import sys

import nbformat
from nbclient import NotebookClient

SECONDS = 600    # per cell
path, folder, result = sys.argv[1:4]
times = int(sys.argv[4]) if len(sys.argv) > 4 else 1
notebook = nbformat.read(path, 4)
client = NotebookClient(notebook, timeout=SECONDS, kernel_name="python3", resources={"metadata": {"path": folder}}, record_timing=False)
with client.setup_kernel():
    for number in range(times):
        for index, cell in enumerate(notebook.cells):
            client.execute_cell(cell, index, execution_count=None if cell.cell_type != "code" else sum(
                one.cell_type == "code" for one in notebook.cells[:index + 1]))
nbformat.write(notebook, result)
