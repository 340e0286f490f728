// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.python.antlr.Visitor;
import org.python.antlr.ast.Assign;
import org.python.antlr.ast.Attribute;
import org.python.antlr.ast.BinOp;
import org.python.antlr.ast.Call;
import org.python.antlr.ast.Compare;
import org.python.antlr.ast.Expr;
import org.python.antlr.ast.ImportFrom;
import org.python.antlr.ast.Name;
import org.python.antlr.ast.Num;
import org.python.antlr.ast.Tuple;
import org.python.antlr.ast.operatorType;
import org.python.antlr.base.expr;
import org.python.core.CompileMode;
import org.python.core.CompilerFlags;
import org.python.core.ParserFacade;
import org.python.core.PyException;
import org.python.core.PyFloat;
import org.python.core.PyInteger;
import org.python.core.PyObject;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Mistakes that Python accepts silently: integer division, a decimal comma, a call without brackets, radians for
 * degrees, centimetres for metres. One script.
 */
final class SilentMistakes extends Visitor {
    private static final Logger LOG = LoggerFactory.getLogger(SilentMistakes.class);
    private static final Pattern DECIMAL_COMMA = Pattern.compile("[^=]*=\\s*(-?\\d+),(\\d+)\\s*;?\\s*(?:#.*)?");
    /** Calls that take degrees. */
    private static final Set<String> ANGLES = Set.of("spin", "rotate", "setSteering", "setServo");
    /** Shortest literal wait that is reported, s. */
    private static final double LONG = 1000;
    private static final double MILLIS = 1000;
    /** Beyond the range of SEAR's distance sensors, m. */
    private static final double FAR = 10;
    private static final double CENTIMETRES = 100;
    /** Degrees. */
    private static final double HALF_ROUND = 90;
    private final List<String> found = new ArrayList<>();
    private final String file;
    private boolean trueDivision;

    private SilentMistakes(String file) {
        this.file = file;
    }

    /**
     * Returns a script's mistakes, each with its line; none for code with syntax errors, which are reported elsewhere.
     */
    static List<String> in(byte[] code, String file) {
        SilentMistakes mistakes = new SilentMistakes(file);
        try {
            mistakes.visit(ParserFacade.parse(new ByteArrayInputStream(code), CompileMode.exec, file, new CompilerFlags()));
        } catch (PyException e) {
            return List.of();
        } catch (Exception e) { // declared by Jython's visitor
            LOG.debug("{} was not looked through", file, e);
            return List.of();
        }
        return mistakes.found;
    }

    private void report(int line, String text) {
        found.add("line " + line + " of " + file + ": " + text);
    }

    @Override
    public Object visitImportFrom(ImportFrom node) throws Exception {
        trueDivision |= "__future__".equals(node.getInternalModule())
            && node.getInternalNames().stream().anyMatch(name -> name.getInternalName().equals("division"));
        return super.visitImportFrom(node);
    }

    @Override
    public Object visitBinOp(BinOp node) throws Exception {
        if (node.getInternalOp() == operatorType.Div && node.getInternalLeft() instanceof Num && node.getInternalRight() instanceof Num) {
            Object left = ((Num) node.getInternalLeft()).getInternalN();
            Object right = ((Num) node.getInternalRight()).getInternalN();
            if (!trueDivision && left instanceof PyInteger && right instanceof PyInteger) {
                reportDivision(node.getLineno(), ((PyInteger) left).getValue(), ((PyInteger) right).getValue());
            }
        }
        return super.visitBinOp(node);
    }

    private void reportDivision(int line, int left, int right) {
        if (right != 0 && left % right != 0) {
            report(line, left + " / " + right + " is " + left / right + " in Python 2.7 (integer division): write " + left + ".0 / " + right);
        }
    }

    @Override
    public Object visitAssign(Assign node) throws Exception {
        boolean toOne = node.getInternalTargets().size() == 1 && node.getInternalTargets().get(0) instanceof Name;
        String line = line(node.getLineno());
        Matcher comma = DECIMAL_COMMA.matcher(line);
        if (toOne && node.getInternalValue() instanceof Tuple && comma.matches()) {
            report(node.getLineno(), comma.group(1) + "," + comma.group(2) + " is two numbers, " + comma.group(1) + " and " + comma.group(2)
                + ": write decimals with a point, " + comma.group(1) + "." + comma.group(2));
        }
        return super.visitAssign(node);
    }

    @Override
    public Object visitCall(Call node) throws Exception {
        String call = node.getInternalFunc() instanceof Attribute ? ((Attribute) node.getInternalFunc()).getInternalAttr() : "";
        List<expr> values = node.getInternalArgs();
        if (ANGLES.contains(call) && values.stream().anyMatch(SilentMistakes::isOfRadians)) {
            report(node.getLineno(), call + " takes degrees, but this value is in radians: 90 is a quarter turn");
        }
        if (call.equals("simSleep") && values.size() == 1 && number(values.get(0)) >= LONG) {
            String seconds = whole(number(values.get(0)));
            report(node.getLineno(), "simSleep(" + seconds + ") waits " + seconds + " s; if these are milliseconds, write simSleep("
                + whole(number(values.get(0)) / MILLIS) + ")");
        }
        if (node.getInternalFunc() instanceof Name && ((Name) node.getInternalFunc()).getInternalId().equals("LIDAR") && values.size() > 2
            && number(values.get(1)) >= HALF_ROUND && number(values.get(2)) < HALF_ROUND) {
            report(node.getLineno(), "this LIDAR has a range of " + whole(number(values.get(1))) + " m and a spread of "
                + whole(number(values.get(2))) + " degrees: the range comes before the spread, LIDAR(name, range, spread, resolution)");
        }
        return super.visitCall(node);
    }

    @Override
    public Object visitCompare(Compare node) throws Exception {
        double limit = node.getInternalComparators().size() == 1 ? number(node.getInternalComparators().get(0)) : Double.NaN;
        boolean isDistance = node.getInternalLeft() instanceof Call && ((Call) node.getInternalLeft()).getInternalFunc() instanceof Attribute
            && ((Attribute) ((Call) node.getInternalLeft()).getInternalFunc()).getInternalAttr().equals("getDistanceResult");
        if (isDistance && limit >= FAR) {
            report(node.getLineno(), "getDistanceResult returns metres, and " + whole(limit) + " m is beyond the range of such sensors; if these are"
                + " centimetres, write " + whole(limit / CENTIMETRES));
        }
        return super.visitCompare(node);
    }

    private static boolean isOfRadians(expr value) {
        if (value instanceof BinOp) {
            return isOfRadians(((BinOp) value).getInternalLeft()) || isOfRadians(((BinOp) value).getInternalRight());
        }
        if (value instanceof Call) {
            return isNamed(((Call) value).getInternalFunc(), "radians");
        }
        return isNamed(value, "pi");
    }

    private static boolean isNamed(expr value, String name) {
        return value instanceof Name && ((Name) value).getInternalId().equals(name)
            || value instanceof Attribute && ((Attribute) value).getInternalAttr().equals(name);
    }

    /** Returns the number; NaN for anything else. */
    private static double number(expr value) {
        Object number = value instanceof Num ? ((Num) value).getInternalN() : null;
        return number instanceof PyInteger || number instanceof PyFloat ? ((PyObject) number).asDouble() : Double.NaN;
    }

    private static String whole(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }

    private String line(int number) {
        List<String> lines = SourceLine.lines(file);
        return number >= 1 && number <= lines.size() ? lines.get(number - 1) : "";
    }

    @Override
    public Object visitExpr(Expr node) throws Exception {
        if (node.getInternalValue() instanceof Attribute) {
            Attribute named = (Attribute) node.getInternalValue();
            String name = named.getInternalValue() instanceof Name ? ((Name) named.getInternalValue()).getInternalId() + "." + named.getInternalAttr()
                : named.getInternalAttr();
            report(node.getLineno(), name + " is named but not called: write " + name + "(...)");
        }
        return super.visitExpr(node);
    }
}
