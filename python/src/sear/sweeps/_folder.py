# SPDX-License-Identifier: Apache-2.0
"""The folder of a sweep: its plan (sweep.json), each finished row (journal.jsonl), and the tables (rows.csv,
rows.parquet)."""
import csv
import io
import json
import os

from .._files import whole

PLAN = "sweep.json"
JOURNAL = "journal.jsonl"
CSV = "rows.csv"
PARQUET = "rows.parquet"
LAST = ("status", "message", "version", "digest")


def columns(rows):
    """Returns all columns: row, seed, parameters, results in order of appearance, status."""
    results = {}
    for one in rows:
        results.update(dict.fromkeys(one["results"]))
    parameters = list(rows[0]["parameters"]) if rows else []
    return ["row", "seed"] + parameters + list(results) + list(LAST)


def flat(row, names):
    """Returns a row as a dictionary with all columns; missing values are None."""
    values = {"row": row["row"], "seed": row["seed"], **row["parameters"], **row["results"], **{name: row[name] for name in LAST}}
    return {name: values.get(name) for name in names}


def text(value):
    """Formats a value for the CSV table; numbers have enough digits to be read back exactly."""
    return "" if value is None else str(value).lower() if isinstance(value, bool) else repr(value) if isinstance(value, float) else str(value)


def lines(rows):
    """Returns the CSV table with its header."""
    names = columns(rows)
    made = io.StringIO()
    writer = csv.writer(made, lineterminator="\n")
    writer.writerow(names)
    for one in rows:
        writer.writerow([text(value) for value in flat(one, names).values()])
    return made.getvalue()


def parquet(rows, path):
    """Writes the columnar table: integers, numbers, booleans or texts; a column of mixed kinds is text."""
    import pyarrow
    from pyarrow import parquet as format
    names = columns(rows)
    made = [flat(one, names) for one in rows]
    arrays = []
    for name in names:
        values = [one[name] for one in made]
        kinds = {type(one) for one in values if one is not None}
        if kinds == {bool}:
            kind = pyarrow.bool_()
        elif kinds == {int}:
            kind = pyarrow.int64()
        elif kinds and kinds <= {int, float}:
            kind, values = pyarrow.float64(), [None if one is None else float(one) for one in values]
        else:
            kind, values = pyarrow.string(), [None if one is None else text(one) for one in values]
        arrays.append(pyarrow.array(values, kind))
    format.write_table(pyarrow.table(arrays, names=names), path)


class Folder:
    """The folder of one sweep. One thread."""

    def __init__(self, path):
        self.path = path
        self._journal = None

    def _at(self, name):
        return os.path.join(self.path, name)

    def plan(self):
        """Returns the stored plan of the sweep; None if there is none."""
        try:
            with open(self._at(PLAN), encoding="utf-8") as file:
                return json.load(file)
        except FileNotFoundError:
            return None

    def forget(self):
        """Deletes the files of a sweep, and no others."""
        for name in (PLAN, JOURNAL, CSV, PARQUET):
            if os.path.exists(self._at(name)):
                os.remove(self._at(name))

    def begin(self, plan):
        """Opens the folder; returns its rows by number.

        Raises ValueError if they belong to another sweep, OSError if the folder is not writable.
        """
        os.makedirs(self.path, exist_ok=True)
        there = self.plan()
        if there is None:
            self.forget()
            with whole(self._at(PLAN)) as aside, open(aside, "w", encoding="utf-8") as file:
                json.dump(plan, file, indent=1)
        elif json.loads(json.dumps(plan)) != there:
            other = [name for name in plan if json.loads(json.dumps(plan[name])) != there.get(name)]
            raise ValueError("%s has the rows of another sweep, with another %s: choose another folder, or start over there (--fresh)"
                             % (self.path, " and ".join(other)))
        self._journal = open(self._at(JOURNAL), "a+b")
        self._lock()
        rows = self._read()
        return {one["row"]: one for one in rows}

    def _lock(self):
        try:
            import fcntl
        except ImportError:
            return    # Windows
        try:
            fcntl.flock(self._journal, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise ValueError("another sweep is using %s: choose another folder" % self.path) from None

    def _read(self):
        """Reads all complete lines; truncates an incomplete last one."""
        self._journal.seek(0)
        rows = []
        end = 0
        for line in self._journal:
            if not line.endswith(b"\n"):
                break
            rows.append(json.loads(line))
            end += len(line)
        self._journal.truncate(end)
        return rows

    def rows(self):
        """Returns all rows by number, without opening the journal for writing."""
        with open(self._at(JOURNAL), "rb") as file:
            return {one["row"]: one for one in (json.loads(line) for line in file if line.endswith(b"\n"))}

    def add(self, rows):
        """Appends rows to the journal."""
        self._journal.write(b"".join(json.dumps(one).encode("ascii") + b"\n" for one in rows))
        self._journal.flush()

    def tables(self, rows):
        """Writes both tables atomically."""
        with whole(self._at(CSV)) as table, whole(self._at(PARQUET)) as columnar:
            with open(table, "w", encoding="utf-8", newline="") as file:
                file.write(lines(rows))
            parquet(rows, columnar)

    def close(self):
        """Closes the journal."""
        if self._journal is not None:
            self._journal.close()
