package rasterlab.exercises.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.geom.Rectangle2D;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.CustomBlock;
import org.commonmark.node.CustomNode;
import org.commonmark.parser.Parser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.scilab.forge.jlatexmath.MacroInfo;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;

class FormulasTest {
    private final Formulas formulas = new Formulas();

    private Typeset.FormulaOutline drawn(String tex) {
        Typeset set = formulas.set(new TexFormula(tex, false));
        return assertInstanceOf(Typeset.FormulaOutline.class, set, () -> tex + ": " + set);
    }

    @Test
    void standsOnItsBaseline() {
        Rectangle2D x = drawn("x").outline().getBounds2D();
        assertEquals(0, x.getMaxY(), 0.02, "an x ends at the line");
        assertEquals(-Typeset.FormulaOutline.X_HEIGHT, x.getMinY(), 0.02, "height of an x");
        assertEquals(
                -Typeset.FormulaOutline.CAPITAL_HEIGHT,
                drawn("E").outline().getBounds2D().getMinY(),
                0.02,
                "height of a capital");
        assertTrue(drawn("p").outline().getBounds2D().getMaxY() > 0.15, "a p goes below");
    }

    @ParameterizedTest(name = "{0} runs together")
    @ValueSource(strings = {"0, 1", "(1; 2)", "|a|, |b|", "x_0, x_1", "0, \\dots, n"})
    void aListHasSpacesAfterItsSigns(String list) {
        double tight = drawn(list.replaceAll("([,;]) ", "{$1}")).width();
        assertTrue(drawn(list).width() > tight + 0.1, list);
    }

    @Test
    void aMinusAfterACommaIsThatOfANumber() {
        double positive = drawn("(0, 2)").width();
        double minus = drawn("-2").width() - drawn("2").width();
        assertEquals(minus, drawn("(0, -2)").width() - positive, 0.01);
        assertEquals(drawn("0;\\ {-}2").width(), drawn("0;\\ -2").width(), 1e-6);
        assertEquals(drawn("a, {\\pm}b").width(), drawn("a, \\pm b").width(), 1e-6);
    }

    @ParameterizedTest(name = "after {0} a difference is set tight")
    @ValueSource(strings = {"(0, -2)", "{-}2", "0{,}5; -1"})
    void aSignKeepsItsSpacesAfterOneWithout(String signs) {
        drawn(signs);
        double parts = drawn("v^2").width() + drawn("w").width() + drawn("{-}").width();
        assertTrue(drawn("v^2 - w").width() > parts + 0.4, signs);
        double list = drawn("a").width() + drawn("b").width() + drawn("{,}").width();
        assertTrue(drawn("a, b").width() > list + 0.1, signs);
    }

    @Test
    void aNumberAndWordsKeepTheirCommas() {
        assertEquals(drawn("0{,}1").width(), drawn("0,1").width(), 1e-6);
        double words = drawn("\\text{a, b}").width();
        assertTrue(words > drawn("\\text{a,b}").width() + 0.2, "a space of words is wider");
    }

    @ParameterizedTest(name = "the size leaves out a part of {0}")
    @ValueSource(strings = {"x", "\\frac{a}{b}", "\\sqrt{x^2}", "x_1", "\\boxed{a}", "\\sum_i^n"})
    void saysHowLargeItIs(String tex) {
        Typeset.FormulaOutline formula = drawn(tex);
        Rectangle2D ink = formula.outline().getBounds2D();
        double leeway = 0.06;
        assertTrue(ink.getMinX() > -leeway && ink.getMaxX() < formula.width() + leeway, tex);
        assertTrue(-ink.getMinY() < formula.height() + leeway, tex);
        assertTrue(ink.getMaxY() < formula.depth() + leeway, tex);
        assertTrue(formula.width() < ink.getWidth() + 0.5, tex);
    }

    @Test
    void setsLettersOfBothLanguagesWithoutFontsOfTheMachine() {
        for (char letter : "AaZzАаЯяЁё".toCharArray())
            assertTrue(
                    drawn("\\text{" + letter + "}").outline().getBounds2D().getHeight() > 0.3,
                    "no letter " + letter);
    }

    @Test
    void hasMoreRoomOnLinesOfItsOwn() {
        var inline = drawn("\\frac{a}{b}");
        var own = (Typeset.FormulaOutline) formulas.set(new TexFormula("\\frac{a}{b}", true));
        assertTrue(own.height() > 1.2 * inline.height());
    }

    @Test
    void leavesAGapBeforeTheConditionsOfCases() {
        String explicit = "\\left\\{\\begin{array}{l}1,\\quad x\\end{array}\\right.";
        double cases = drawn("\\begin{cases}1,&x\\end{cases}").width();
        assertEquals(drawn(explicit).width(), cases, 0.3);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void names(String said, String tex) {
        Typeset set = formulas.set(new TexFormula(tex, true));
        var mistake = assertInstanceOf(Typeset.Mistaken.class, set, () -> "drawn: " + tex);
        assertEquals(said, mistake.message().in("en"));
        assertNotEquals(said, mistake.message().in("ru"));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("nothing is drawn", "there is nothing between the dollars", " "),
                argumentSet("unknown command", unknown("\\foo"), "\\foo{x}"),
                argumentSet("unknown surroundings", unknown("\\begin{foo}"), "\\begin{foo}"),
                argumentSet("a brace is not closed", "} is missing", "x^{2"),
                argumentSet("a brace is not opened", "} closes nothing", "x}"),
                argumentSet("a bracket is not closed", "\\right is missing", "\\left(x"),
                argumentSet("a bracket is missing", lacks("\\left"), "\\left"),
                argumentSet("end of another", "} stands where \\right is expected", "\\left(x}"),
                argumentSet("fraction of one", lacks("\\frac"), "{\\frac{1}}"),
                argumentSet("nothing above", lacks("^"), "x^"),
                argumentSet("& outside a table", "the character & cannot stand at place 3", "a &"),
                argumentSet("comment", "the character % cannot stand at place 3", "a % b"),
                argumentSet("unknown letter", "the character 中 cannot stand at place 1", "中"),
                argumentSet(
                        "100 kB",
                        "the formula has 100000 characters, 2000 are allowed",
                        "x".repeat(100_000)),
                argumentSet(
                        "wide as a street",
                        "the formula would be 401 em wide or high, 200 are allowed",
                        "x^".repeat(999) + "x"));
    }

    private static String unknown(String command) {
        return command + " is not a command that is known here";
    }

    private static String lacks(String command) {
        return command + " lacks what it is to be applied to";
    }

    @ParameterizedTest(name = "the library runs {0}")
    @ValueSource(
            strings = {
                "\\includegraphics{/etc/hostname}",
                "\\input{/etc/hostname}",
                "\\newcommand{\\a}{\\a\\a}\\a",
                "\\renewcommand{\\frac}{x}",
                "\\newenvironment{a}{b}{c}",
                "\\DeclareMathSizes{10}{10}{10}{10}",
                "\\definecolor{red}{rgb}{0,0,0}",
                "\\jlmExternalFont{Serif}{x}",
                "\\jlmDynamic{x}",
                "\\magnification{1000}",
                "\\makeatletter\\matrix@@env{a}",
                "\\rule{1000em}{1000em}",
                "\\kern1000em",
                "\\scalebox{1000}{x}",
                "\\char\"41",
                "\\text{\\includegraphics{/etc/hostname}}",
                "\\sqrt[\\kern1em]{x}",
                "\\begin{array}{*{1000000}{c}}a\\end{array}"
            })
    void runsNothingButFormulas(String tex) {
        Set<String> before = new HashSet<>(MacroInfo.Commands.keySet());
        assertInstanceOf(Typeset.Mistaken.class, formulas.set(new TexFormula(tex, false)), tex);
        drawn("\\frac{a}{b}");
        assertEquals(before, MacroInfo.Commands.keySet());
    }

    /** Signs around a deep formula double with each level in the library. */
    @ParameterizedTest(name = "{0} in itself fills the memory")
    @ValueSource(
            strings = {
                "\\dbinom{1}{",
                "\\dbinom1",
                "\\binom{1}{",
                "\\sqrt{",
                "\\left(\\frac{1}{",
                "\\hat ",
                "\\overbrace{",
                "\\begin{pmatrix}",
                "\\begin{cases}",
                "\\substack{",
                "{",
                "x^{",
                "\\frac1"
            })
    void boundsHowDeepFormulasLie(String begin) {
        for (int deep = 1; deep < 100; deep++) {
            var set =
                    formulas.set(new TexFormula(begin.repeat(deep) + "x" + end(begin, deep), true));
            if (set instanceof Typeset.Mistaken mistake) {
                String key = mistake.message().sentences().get(0).key();
                assertTrue(Set.of("formula.deep", "formula.large").contains(key), key);
                return;
            }
        }
        throw new AssertionError("100 times " + begin + " are drawn");
    }

    private static String end(String begin, int deep) {
        String end = begin.endsWith("{") ? "}" : "";
        if (begin.startsWith("\\begin")) end = begin.replace("begin", "end");
        if (begin.startsWith("\\left")) end = "}\\right)";
        return end.repeat(deep);
    }

    @Test
    void isRemembered() {
        var formula = new TexFormula("y", false);
        assertEquals(Optional.empty(), formulas.known(formula));
        Typeset set = formulas.set(formula);
        assertSame(set, formulas.set(formula));
        assertSame(set, formulas.known(formula).orElseThrow());
    }

    @Test
    void formulasOfTheBuiltInStatementsAreDrawn() {
        var parser = Parser.builder().extensions(List.of(new FormulaMarkdown())).build();
        for (var exercise : Catalogue.builtIn().all())
            for (String language : List.of("en", "ru")) {
                var found = new HashSet<TexFormula>();
                parser.parse(exercise.statement(language))
                        .accept(
                                new AbstractVisitor() {
                                    @Override
                                    public void visit(CustomNode node) {
                                        if (node instanceof InlineFormula inline)
                                            found.add(inline.formula());
                                    }

                                    @Override
                                    public void visit(CustomBlock node) {
                                        if (node instanceof FormulaBlock block)
                                            found.add(block.formula());
                                    }
                                });
                for (TexFormula formula : found)
                    assertInstanceOf(
                            Typeset.FormulaOutline.class, formulas.set(formula), formula.tex());
                assertTrue(
                        !found.isEmpty() || exercise.form() != TaskKind.WRITE,
                        exercise.id() + " in " + language + ": " + found);
            }
    }
}
