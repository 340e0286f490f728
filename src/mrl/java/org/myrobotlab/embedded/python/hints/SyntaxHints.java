// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python.hints;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Hints for lines that are not Python 2.7: Python 3, another language, or a forgotten character. Any thread. */
public final class SyntaxHints {
    private static final String OLD_PYTHON = "scripts are Python 2.7 (Jython)";
    private static final Pattern F_STRING = Pattern.compile("(?i)\\b(f|fr|rf)[\"']");
    private static final Pattern PRINT = Pattern.compile("\\bprint\\s*\\(");
    private static final Pattern DEF = Pattern.compile("^\\s*def\\s+(\\w+)\\s*\\((.*)\\)\\s*(?:->.*)?:.*");
    private static final Pattern BLOCK = Pattern.compile("^\\s*(if|elif|else|while|for|def|class|try|except|finally|with)\\b.*");
    private static final Pattern CONDITION = Pattern.compile("^\\s*(if|elif|while)\\b.*[^=!<>+*/%-]=(?!=).*");
    private static final Pattern WORD_OF_PYTHON = Pattern.compile("^\\s*(and|as|assert|break|class|continue|def|del|elif|else|except|exec|finally|for"
        + "|from|global|if|import|in|is|lambda|not|or|pass|print|raise|return|try|while|with|yield)\\s*=(?!=).*");
    /** Pairs of a pattern for the line and its hint; $1 and the like stand for the pattern's groups. */
    private static final String[][] LINES = {
        {"^\\s*async\\b.*|.*\\bawait\\s.*", OLD_PYTHON + ", which has no async and await: write def, and call sear.simSleep(seconds) directly"},
        {"^\\s*match\\s+.*:\\s*$|^\\s*case\\s+.*:\\s*$", OLD_PYTHON + ", which has no match: write if, elif and else"},
        {".*:=.*", OLD_PYTHON + ", which has no := : assign the name in a separate line, before the loop and at its end"},
        {".*\\b(\\d+)_(\\d[\\d_]*).*", OLD_PYTHON + ", where numbers have no _: write $1$2"},
        {"^\\s*nonlocal\\b.*", OLD_PYTHON + ", which has no nonlocal: keep the value in a list, count = [0], and set count[0]"},
        {"^\\s*raise\\s.*\\sfrom\\s.*", OLD_PYTHON + ", where raise has no from"},
        {"^\\s*(\\w+)\\s*:\\s*[\\w.\\[\\]]+\\s*=\\s*(.*\\S)\\s*", OLD_PYTHON + ", where variables have no types: write $1 = $2"},
        {"^\\s*except\\s+([\\w.]+)\\s+(\\w+)\\s*:.*", "name the error with as: except $1 as $2:"},
        {"^\\s*(?:else\\s+if|elseif|elsif)\\b.*", "else if is one word in Python: elif"},
        {".*(\\b\\w+)\\s*\\+\\+.*|.*\\+\\+\\s*(\\w+).*", "Python has no ++: write $1 += 1"},
        {".*(\\b\\w+)\\s*--\\s*;?\\s*$", "Python has no --: write $1 -= 1"},
        {".*(&&|\\|\\|).*", "write and for &&, or for ||"},
        {".*[(\\s]!(?!=).*", "write not for !"},
        {"^\\s*(?:int|float|double|var|let|const|auto|bool|boolean|String|string|byte|long)\\s+(\\w+)\\s*=\\s*(.*?)\\s*;?\\s*",
            "variables have no types in Python: write $1 = $2"},
        {"^\\s*(?:function|func|void|fn)\\s+(\\w+).*", "a function starts with def: def $1():"},
        {".*(?<![\\w.])(\\d+(?:\\.\\d+)?)\\s*(?:mm|cm|dm|m|km|deg|rad|kg|g|s|ms)\\b.*",
            "numbers have no units: write $1; lengths are in metres, times in seconds"},
        {".*\\?.*:.*", "Python has no ? : operator: write a if condition else b"},
    };
    private static final List<Rule> RULES = rules();

    private SyntaxHints() {
    }

    /** A pattern for lines and its hint. */
    private static final class Rule {
        final Pattern line;
        final String hint;

        Rule(String line, String hint) {
            this.line = Pattern.compile(line);
            this.hint = hint;
        }
    }

    private static List<Rule> rules() {
        List<Rule> rules = new ArrayList<>();
        for (String[] one : LINES) {
            rules.add(new Rule(one[0], one[1]));
        }
        return rules;
    }

    /**
     * Returns a hint for an error in a line.
     *
     * @param said Jython's message
     * @return a line to append to the error; empty without a hint
     */
    public static String of(SourceScan scan, int line, String said) {
        String hint = hint(scan, line, said);
        return hint.isEmpty() ? "" : "\n" + hint;
    }

    private static String hint(SourceScan scan, int line, String said) {
        String code = scan.code(line);
        String[] hints = {modern(scan.line(line), code), braces(scan, line), known(scan.line(line), code), text(scan, line, code),
            scan.brackets(line), print(code), condition(code), colon(code, said), Indents.hint(scan, line, said)};
        for (String hint : hints) {
            if (!hint.isEmpty()) {
                return hint;
            }
        }
        return "";
    }

    private static String modern(String line, String code) {
        if (F_STRING.matcher(code).find()) {
            return OLD_PYTHON + ", which has no f-strings: write \"%d m\" % metres";
        }
        Matcher def = DEF.matcher(code);
        if (def.matches() && (def.group(2).contains(":") || code.contains("->"))) {
            Matcher whole = DEF.matcher(line);
            String parameters = (whole.matches() ? whole : def).group(2).replaceAll("\\s*:\\s*[\\w.]+(\\[[^\\]]*\\])*", "");
            return OLD_PYTHON + ", where functions have no types: write def " + def.group(1) + "(" + parameters + "):";
        }
        Matcher word = WORD_OF_PYTHON.matcher(code);
        return word.matches() ? word.group(1) + " is a keyword of Python: choose another name" : "";
    }

    private static String known(String line, String code) {
        for (Rule rule : RULES) {
            if (rule.line.matcher(code).matches()) {
                Matcher whole = rule.line.matcher(line);
                Matcher found = whole.matches() ? whole : rule.line.matcher(code);
                return found.matches() ? filled(rule.hint, found) : "";
            }
        }
        return "";
    }

    private static String filled(String hint, Matcher found) {
        String filled = hint;
        for (int i = 1; i <= found.groupCount(); i++) {
            String group = found.group(i) == null && i < found.groupCount() ? found.group(i + 1) : found.group(i);
            filled = filled.replace("$" + i, group == null ? "" : group);
        }
        return filled;
    }

    private static String braces(SourceScan scan, int line) {
        for (int i = scan.before(line + 1); i > 0 && i >= line - 1; i--) {
            if (scan.code(i).matches("^\\s*(\\}\\s*)?(if|elif|else|while|for|def|class|try)\\b.*\\{\\s*")) {
                return "blocks have no { } in Python: end the first line with a colon, and indent the others by four spaces";
            }
        }
        return "";
    }

    private static String text(SourceScan scan, int line, String code) {
        SourceScan.Place open = scan.textLeftOpen();
        if (open != null && open.line <= line) {
            return "the string that starts with " + open.character + " in line " + open.line + " has no closing " + open.character;
        }
        return code.matches(".*(\"\\s*\"\\w|'\\s*'\\w|\\w\"\\s*\"|\\w'\\s*').*") && !code.matches("(?i).*\\b(u|r|ur|b|br)[\"'].*")
            ? "write \\\" for a quotation mark inside a string, or enclose the string in '" : "";
    }

    private static String print(String code) {
        return PRINT.matcher(code).find()
            ? OLD_PYTHON + ": write print \"a\", b, or start the script with from __future__ import print_function" : "";
    }

    private static String condition(String code) {
        String outside = code.replaceAll("\\w\\([^()]*\\)", "x").replaceAll("\\w\\([^()]*\\)", "x");
        return CONDITION.matcher(outside).matches() ? "= assigns a value; == compares two values" : "";
    }

    private static String colon(String code, String said) {
        boolean isOpen = said.contains("COLON") || said.contains("NEWLINE") || said.contains("\\n");
        return isOpen && BLOCK.matcher(code).matches() && !code.strip().endsWith(":")
            ? "a line that starts a block (if, else, while, for, def, class) ends with a colon" : "";
    }
}
