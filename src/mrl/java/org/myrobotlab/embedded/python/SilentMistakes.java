package org.myrobotlab.embedded.python;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.python.antlr.Visitor;
import org.python.antlr.ast.Assign;
import org.python.antlr.ast.Attribute;
import org.python.antlr.ast.BinOp;
import org.python.antlr.ast.Expr;
import org.python.antlr.ast.ImportFrom;
import org.python.antlr.ast.Name;
import org.python.antlr.ast.Num;
import org.python.antlr.ast.Tuple;
import org.python.antlr.ast.operatorType;
import org.python.core.CompileMode;
import org.python.core.CompilerFlags;
import org.python.core.ParserFacade;
import org.python.core.PyException;
import org.python.core.PyInteger;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What Python carries out without a word, though it can't be meant: a division of whole numbers, a decimal comma, a call without brackets. One
 * script.
 */
final class SilentMistakes extends Visitor {
    private static final Logger LOG = LoggerFactory.getLogger(SilentMistakes.class);
    private static final Pattern DECIMAL_COMMA = Pattern.compile("[^=]*=\\s*(-?\\d+),(\\d+)\\s*;?\\s*(?:#.*)?");
    private final List<String> found = new ArrayList<>();
    private final String file;
    private boolean trueDivision;

    private SilentMistakes(String file) {
        this.file = file;
    }

    /** Those of a script, each with its line; none if it is no Python, which whoever runs it is told. */
    static List<String> in(byte[] code, String file) {
        SilentMistakes mistakes = new SilentMistakes(file);
        try {
            mistakes.visit(ParserFacade.parse(new ByteArrayInputStream(code), CompileMode.exec, file, new CompilerFlags()));
        } catch (PyException e) {
            return List.of();
        } catch (Exception e) { // what Jython's visitor declares
            LOG.debug("{} was not looked through", file, e);
            return List.of();
        }
        return mistakes.found;
    }

    private void tell(int line, String text) {
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
                tellDivision(node.getLineno(), ((PyInteger) left).getValue(), ((PyInteger) right).getValue());
            }
        }
        return super.visitBinOp(node);
    }

    private void tellDivision(int line, int left, int right) {
        if (right != 0 && left % right != 0) {
            tell(line, left + " / " + right + " is " + left / right + " in Python 2.7, which divides whole numbers without a rest: write " + left
                + ".0 / " + right);
        }
    }

    @Override
    public Object visitAssign(Assign node) throws Exception {
        boolean toOne = node.getInternalTargets().size() == 1 && node.getInternalTargets().get(0) instanceof Name;
        String line = line(node.getLineno());
        Matcher comma = DECIMAL_COMMA.matcher(line);
        if (toOne && node.getInternalValue() instanceof Tuple && comma.matches()) {
            tell(node.getLineno(), comma.group(1) + "," + comma.group(2) + " is two numbers, " + comma.group(1) + " and " + comma.group(2)
                + ": a decimal number is written with a point, " + comma.group(1) + "." + comma.group(2));
        }
        return super.visitAssign(node);
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
            tell(node.getLineno(), name + " is only named and not called: write " + name + "(...)");
        }
        return super.visitExpr(node);
    }
}
