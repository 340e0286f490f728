# SPDX-License-Identifier: Apache-2.0
"""Explains syntax errors: another version of Python, another language, a forgotten or foreign character, indentation.

Scans scripts by an expression of its own: tokenize stops at the first error, at another place in each Python.
"""
import re

from . import line_of, lines_of
from .names import PYTHON3

_PAIRS = {"(": ")", "[": "]", "{": "}"}
_TOKEN = re.compile(u"""(?P<comment>\\#[^\\n]*)
    |(?P<text>(?P<mark>\\"{3}|'{3})(?:\\\\.|.)*?(?P<end>(?P=mark)|\\Z)|(?P<quote>["'])(?:\\\\.|[^\\\\\\n])*?(?P<close>(?P=quote)|(?=\\n)|\\Z))
    |(?P<bracket>[][(){}])|(?P<foreign>[^\\x00-~])""", re.S | re.X)
_OLD = "scripts are Python 2.7 (Jython)"
_INSTEAD = dict((one, legal) for legal, characters in (
    ('"', u"\u201c\u201d\u201e\u201f\xab\xbb"), ("'", u"\u2018\u2019\u201a\u201b\u2039\u203a\xb4"),
    ("-", u"\u2010\u2011\u2012\u2013\u2014\u2015\u2212"), ("*", u"\xd7\xb7\u22c5\u2217"), ("/", u"\xf7\u2215"), ("<=", u"\u2264"),
    (">=", u"\u2265"), ("!=", u"\u2260"), ("**2", u"\xb2"), ("**3", u"\xb3")) for one in characters)
_NOT_IN_2 = [(re.compile(pattern), _OLD + hint) for pattern, hint in (
    (r"\b([fF]|[fF][rR]|[rR][fF])[\"']", ", which has no f-strings: write \"%d m\" % metres"),
    (r"^\s*async\b|\bawait\s", ", which has no async and await: write def, and call sear.simSleep(seconds) directly"),
    (r"^\s*(match|case)\s+.*:\s*$", ", which has no match: write if, elif and else"),
    (r":=", ", which has no := : assign the name in a separate line, before the loop and at its end"),
    (r"\b(\d+)_(\d[\d_]*)", ", where numbers have no _: write $1$2"),
    (r"^\s*nonlocal\b", ", which has no nonlocal: keep the value in a list, count = [0], and set count[0]"),
    (r"^\s*raise\s.*\sfrom\s", ", where raise has no from"),
    (r"^\s*(\w+)\s*:\s*[\w.\[\]]+\s*=\s*(.*\S)\s*$", ", where variables have no types: write $1 = $2"))]
_OTHERS = [(re.compile(pattern), hint) for pattern, hint in (
    (r"^\s*(and|as|assert|break|class|continue|def|del|elif|else|except|exec|finally|for|from|global|if|import|in|is|lambda|not|or|pass"
     r"|print|raise|return|try|while|with|yield)\s*=(?!=)", "$1 is a keyword of Python: choose another name"),
    (r"^\s*except\s+([\w.]+)\s+(\w+)\s*:", "name the error with as: except $1 as $2:"),
    (r"^\s*(?:else\s+if|elseif|elsif)\b", "else if is one word in Python: elif"),
    (r"(\b\w+)\s*\+\+|\+\+\s*(\w+)", "Python has no ++: write $1 += 1"),
    (r"(\b\w+)\s*--\s*;?\s*$", "Python has no --: write $1 -= 1"),
    (r"&&|\|\|", "write and for &&, or for ||"),
    (r"[(\s]!(?!=)", "write not for !"),
    (r"^\s*(?:int|float|double|var|let|const|auto|bool|boolean|String|string|byte|long)\s+(\w+)\s*=\s*(.*?)\s*;?\s*$",
     "variables have no types in Python: write $1 = $2"),
    (r"^\s*(?:function|func|void|fn)\s+(\w+)", "a function starts with def: def $1():"),
    (r"(?<![\w.])(\d+(?:\.\d+)?)\s*(?:mm|cm|dm|m|km|deg|rad|kg|g|s|ms)\b",
     "numbers have no units: write $1; lengths are in metres, times in seconds"),
    (r"\?.*:", "Python has no ? : operator: write a if condition else b"))]
_DEF = re.compile(r"^\s*def\s+(\w+)\s*\((.*)\)\s*(->.*)?:")
_BLOCK = re.compile(r"^\s*(if|elif|else|while|for|def|class|try|except|finally|with)\b")


class Scan(object):
    """A script, which may be invalid. Lines count from 1, columns from 0.

    lines: as they are. code: the same without comments, with spaces for the contents of strings.
    foreign, text: line, column and character of the first character that Python doesn't know, and of the first unclosed
        string; None without one.
    brackets: line and text of the first mistake with brackets; None without one.
    """

    def __init__(self, source):
        self.lines = lines_of(source)
        source = "\n".join(self.lines)
        self.foreign = self.text = self.brackets = None
        plain, opened, end = [], [], 0
        for token in _TOKEN.finditer(source):
            plain.append(source[end:token.start()])
            end = token.end()
            plain.append(self._plain(source, token, opened))
        self.code = ("".join(plain) + source[end:]).split("\n")
        if opened and not self.brackets:
            line, _, character = opened[-1]
            self.brackets = line, "the bracket %s in line %d has no closing %s" % (character, line, _PAIRS[character])

    def _plain(self, source, token, opened):
        text = token.group()
        place = source.count("\n", 0, token.start()) + 1, token.start() - source.rfind("\n", 0, token.start()) - 1, text
        if token.group("comment"):
            return ""
        if token.group("text"):
            mark = token.group("mark") or token.group("quote")
            is_closed = token.group("end") or token.group("close")
            if not is_closed:
                self.text = self.text or place[:2] + (mark[0],)
            inside = text[len(mark):len(text) - len(mark) if is_closed else len(text)]
            return mark + re.sub("[^\n]", " ", inside) + (mark if is_closed else "")
        if token.group("bracket"):
            self._bracket(place, opened)
        elif not self.foreign and not (PYTHON3 and (u"_" + text).isidentifier()):
            self.foreign = place
        return text

    def _bracket(self, place, opened):
        line, _, character = place
        if character in _PAIRS:
            opened.append(place)
            return
        before = opened.pop() if opened else None
        if self.brackets or before and _PAIRS[before[2]] == character:
            return
        self.brackets = line, ("the bracket %s in line %d is closed by %s in line %d" % (before[2], before[0], character, line) if before
                               else "the bracket %s in line %d has no opening bracket" % (character, line))

    def line(self, number):
        """Returns a line as it is; empty if there is none."""
        return line_of(self.lines, number)

    def plain(self, number):
        """Returns a line of the code; empty if there is none."""
        return line_of(self.code, number)

    def before(self, number):
        """Returns the number of the last line with code before the given one; 0 if there is none."""
        return next((one for one in range(number - 1, 0, -1) if self.plain(one).strip()), 0)


def shown(file, number, line, column, error):
    """Returns an error as Python prints it.

    column: of the mark, from 0; None if unknown.
    """
    text = line.strip()
    indent = len(line) - len(line.lstrip())
    mark = text and column is not None and column <= len(line)
    return (u"  File \"%s\", line %d" % (file, number) + (text and u"\n    " + text)
            + (u"\n    " + " " * max(0, column - indent) + "^" if mark else u"") + u"\n" + error)


def foreign(character, line="", column=0):
    """Returns a sentence about a character that Python allows only in strings and comments."""
    import unicodedata    # here, because Jython takes 0.1 s of processor time for it
    kind = unicodedata.category(character)
    is_blank = kind in ("Zs", "Zl", "Zp", "Cf") or character.isspace()
    named = u"%s (U+%04X)" % ("an invisible character" if is_blank or kind == "Cc" else character, ord(character))
    plain = unicodedata.normalize("NFKC", character)
    instead = _INSTEAD.get(character) or (plain if not is_blank and all(" " < one <= "~" for one in plain) else "")
    if instead:
        return named + " is not allowed outside strings and comments: write " + instead
    if is_blank:
        return named + " is not a space to Python: write an ordinary space"
    word = next((one.group() for one in re.finditer(r"(?u)\w+", line) if one.start() <= column < one.end()), "")
    if kind.startswith("L") and word:
        return u"the name %s contains %s, legal: a to z, A to Z, 0 to 9 and _" % (word, character)
    return named + " is not allowed outside strings and comments"


def hint(scan, line, message):
    """Returns a hint for a syntax error; empty without one.

    message: Python's.
    """
    if scan.foreign and scan.foreign[0] <= line:
        return foreign(scan.foreign[2], scan.line(scan.foreign[0]), scan.foreign[1])
    whole, code = scan.line(line), scan.plain(line)
    return (not PYTHON3 and _modern(whole, code) or _braces(scan, line) or _known(_OTHERS, whole, code) or _text(scan, line, code)
            or scan.brackets and scan.brackets[0] <= line and scan.brackets[1] or _print(code) or _condition(code) or _colon(code, message)
            or _indentation(scan, line, message))


def _modern(line, code):
    function = _DEF.match(code)
    if function and (":" in function.group(2) or function.group(3)):
        parameters = (_DEF.match(line) or function).group(2)
        return "%s, where functions have no types: write def %s(%s):" % (_OLD, function.group(1),
                                                                         re.sub(r"\s*:\s*[\w.]+(\[[^\]]*\])*", "", parameters))
    return _known(_NOT_IN_2, line, code)


def _known(rules, line, code):
    for pattern, words in rules:
        if pattern.search(code):
            found = pattern.search(line) or pattern.search(code)
            groups = [one for one in found.groups() if one is not None]
            return re.sub(r"\$(\d)", lambda group: groups[int(group.group(1)) - 1], words)
    return ""


def _braces(scan, line):
    opening = re.compile(r"^\s*(\}\s*)?(if|elif|else|while|for|def|class|try)\b.*\{\s*$")
    near = [one for one in range(max(1, line - 1), line + 1) if opening.match(scan.plain(one))]
    return "blocks have no { } in Python: end the first line with a colon, and indent the others by four spaces" if near else ""


def _text(scan, line, code):
    if scan.text and scan.text[0] <= line:
        return "the string that starts with {1} in line {0} has no closing {1}".format(scan.text[0], scan.text[2])
    inside = re.search(r"\"\s*\"\w|'\s*'\w|\w\"\s*\"|\w'\s*'", code) and not re.search(r"(?i)\b(u|r|ur|b|br)[\"']", code)
    return "write \\\" for a quotation mark inside a string, or enclose the string in '" if inside else ""


def _print(code):
    if PYTHON3:
        return "this script is Python 3: write print(\"a\", b)" if re.search(r"^\s*print\s+[^\s=(]", code) else ""
    return (_OLD + ": write print \"a\", b, or start the script with from __future__ import print_function"
            if re.search(r"\bprint\s*\(", code) else "")


def _condition(code):
    for _ in range(2):
        code = re.sub(r"\w\([^()]*\)", "x", code)
    return "= assigns a value; == compares two values" if re.search(r"^\s*(if|elif|while)\b.*[^=!<>+*/%-]=(?!=)", code) else ""


def _colon(code, message):
    is_open = re.search(r"COLON|NEWLINE|\\n|expected ':'|invalid syntax", message)
    return ("a line that starts a block (if, else, while, for, def, class) ends with a colon"
            if is_open and _BLOCK.match(code) and not code.strip().endswith(":") else "")


def _blanks(line):
    return re.match(r"\s*", line).group()


def _indentation(scan, line, message):
    before = scan.before(line)
    own, former = _blanks(scan.line(line)), _blanks(scan.line(before))
    if not before:
        return "the first line of a script starts without spaces" if own else ""
    opens = scan.plain(before).strip().endswith(":")
    if "\t" in own + former and " " in own + former:
        return "line %d starts with %s, line %d with %s: indent with spaces only, four for each block" % (line, _counted(own), before,
                                                                                                       _counted(former))
    if opens and len(own) <= len(former):
        return "the lines of a block are indented: four spaces more than the line with the colon"
    if not opens and len(own) > len(former):
        return ("line %d starts with %s, line %d with %s: lines of one block have the same indentation, and only a line that ends with a"
                " colon starts a new block" % (line, _counted(own), before, _counted(former)))
    legal = set()
    while before:
        blanks = len(_blanks(scan.line(before)))
        if not legal or blanks < min(legal):
            legal.add(blanks)
        before = scan.before(before)
    if len(own) in legal or opens and not (len(own) < len(former) and "dent" in message.lower()):
        return ""
    return "line %d starts with %s, legal here: %s" % (line, _counted(own), ", ".join(str(one) for one in sorted(legal)))


def _counted(blanks):
    tabs = blanks.count("\t")
    plain = len(blanks) - tabs
    words = [] if plain == 0 and tabs else ["1 space" if plain == 1 else "%d spaces" % plain]
    return " and ".join(words + ([] if not tabs else ["a tab" if tabs == 1 else "%d tabs" % tabs]))
