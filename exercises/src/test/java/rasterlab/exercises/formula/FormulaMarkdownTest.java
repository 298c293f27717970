package rasterlab.exercises.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.BulletList;
import org.commonmark.node.CustomBlock;
import org.commonmark.node.CustomNode;
import org.commonmark.node.Heading;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class FormulaMarkdownTest {
    private static Node parsed(String markdown) {
        return Parser.builder().extensions(List.of(new FormulaMarkdown())).build().parse(markdown);
    }

    /** The formulas as in the statement, each in brackets. */
    private static String found(String markdown) {
        var found = new StringBuilder();
        parsed(markdown)
                .accept(
                        new AbstractVisitor() {
                            @Override
                            public void visit(CustomNode node) {
                                put(((InlineFormula) node).formula());
                            }

                            @Override
                            public void visit(CustomBlock node) {
                                var block = (FormulaBlock) node;
                                put(block.formula());
                                if (!block.closed()) found.append("open");
                            }

                            private void put(TexFormula formula) {
                                found.append('[').append(formula.source()).append(']');
                            }
                        });
        return found.toString();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void finds(String expected, String markdown) {
        assertEquals(expected, found(markdown), markdown);
    }

    static Stream<Arguments> mistakes() {
        return Stream.concat(inLines(), onTheirOwn());
    }

    private static Stream<Arguments> inLines() {
        return Stream.of(
                argumentSet("the formula in a line is text", "[$a_b$]", "Let $a_b$ be."),
                argumentSet("only the first of two is one", "[$a$][$b$]", "Let $a$, $b$."),
                argumentSet("the closing dollar of one opens another", "[$a$][$b$]", "$a$ or $b$"),
                argumentSet("prices before their sign are a formula", "", "5 $ or 6 $ each"),
                argumentSet("prices after their sign are a formula", "", "between $5 and $6"),
                argumentSet("a price swallows a formula", "[$x$]", "US$5, or $x$ of it"),
                argumentSet("code is a formula", "", "write `$x$` and `$y`"),
                argumentSet("a formula reaches into code", "", "$a and `b$`"),
                argumentSet("dollars after backslashes are a formula", "", "\\$x\\$"),
                argumentSet("the backslash before the end is overlooked", "[$5\\$$]", "$5\\$$"),
                argumentSet("the formula ends at its line", "[$a\nb$]", "Let $a\nb$ be."),
                argumentSet("the formula goes on after a paragraph", "", "Let $a\n\nb$ be."),
                argumentSet("emphasis breaks a formula", "[$a*b*c$]", "Let $a*b*c$ be."),
                argumentSet("nothing between dollars is a formula", "", "is $ $ or $$ so"),
                argumentSet("two dollars in a line end at one", "[$$a$$]", "so $$a$$ is"));
    }

    private static Stream<Arguments> onTheirOwn() {
        return Stream.of(
                argumentSet("lines of one's own are a paragraph", "[$$a\n- b$$]", "$$\na\n- b\n$$"),
                argumentSet("one line is too few", "[$$a$$]", "text\n$$a$$\ntext"),
                argumentSet("the end must stand alone", "[$$a\nb$$]", "$$a\nb$$"),
                argumentSet("in a list it is code", "[$$a$$]", "- item\n  $$\n  a\n  $$\n- item"),
                argumentSet("code that is indented is a formula", "", "    $$a$$"),
                argumentSet("words after it are lost", "[$$a$$]", "$$a$$ is more than b"),
                argumentSet("a forgotten end goes unnoticed", "[$$a$$]open", "$$\na\n\ntext"));
    }

    @Test
    void aForgottenEndLeavesTheRestOfThePage() {
        Node last = parsed("$$\na\n\n# Heading").getLastChild();
        assertTrue(last instanceof Heading, last.toString());
    }

    @Test
    void aLineOfTheFormulaBeginsNoList() {
        Node node = parsed("$$\na\n- b\n$$").getFirstChild();
        var kinds = new ArrayList<String>();
        for (; node != null; node = node.getNext()) {
            assertFalse(node instanceof BulletList);
            kinds.add(node.getClass().getSimpleName());
        }
        assertEquals(List.of("FormulaBlock"), kinds);
    }
}
