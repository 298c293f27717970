package rasterlab.app.exercise.statement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import javax.swing.text.AttributeSet;
import javax.swing.text.View;
import javax.swing.text.html.CSS;
import javax.swing.text.html.HTMLEditorKit;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.formula.Formulas;
import rasterlab.exercises.formula.TexFormula;

class StatementPaneTest {
    private final Formulas formulas = new Formulas();
    private final List<Throwable> failures = new ArrayList<>();

    @AfterAll
    static void typeIsOfUsualSizeAgain() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @AfterEach
    void nothingFailed() {
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("tables of other tabs get the statement's borders")
    void styleIsItsOwn() {
        LabTheme.LIGHT.install();
        var pane = new StatementPane("Statement", formulas, failures::add);
        assertEquals("solid", border((HTMLEditorKit) pane.getEditorKit()));
        assertEquals("inset", border(new HTMLEditorKit()));
    }

    private static String border(HTMLEditorKit kit) {
        AttributeSet cell = kit.getStyleSheet().getRule("td");
        return cell.getAttribute(CSS.Attribute.BORDER_TOP_STYLE).toString();
    }

    @Test
    @DisplayName("fonts of formulas are read on the event thread")
    void formulasAreSetInTheBackground() throws Exception {
        var pane = new StatementPane[1];
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    pane[0] = new StatementPane("Statement", formulas, failures::add);
                    pane[0].show(saying("Let $n+1$ be."), "en", "");
                    assertTrue(typeset(pane[0]).isEmpty(), "set on the event thread");
                    assertTrue(text(pane[0]).contains("Let $n+1$ be."), text(pane[0]));
                });
        pane[0].settle();
        EventQueue.invokeAndWait(() -> assertEquals(1, typeset(pane[0]).size()));
        assertTrue(formulas.known(new TexFormula("n+1", false)).isPresent());
    }

    @Test
    @DisplayName("what is copied lacks the formulas")
    void theTextHasTheSource() throws Exception {
        StatementPane pane =
                settled("Let $x_0$ be.\n\n$$\n\\frac{a}{b}\n$$\n", LabTheme.LIGHT, 100);
        EventQueue.invokeAndWait(
                () -> {
                    pane.selectAll();
                    String copied = pane.getSelectedText();
                    assertTrue(copied.contains("Let $x_0$ be."), copied);
                    assertTrue(copied.contains("$$\\frac{a}{b}$$"), copied);
                    var spoken = pane.getAccessibleContext().getAccessibleText();
                    assertTrue(spoken.getCharCount() >= copied.length(), "not for a reader");
                });
    }

    @ParameterizedTest(name = "formulas cannot be told from the ground: {0}")
    @EnumSource(LabTheme.class)
    void formulasHaveTheColorOfTheText(LabTheme theme) throws Exception {
        StatementPane pane = settled("$\\boxed{E}$", theme, 200);
        var made = new BufferedImage[1];
        EventQueue.invokeAndWait(() -> made[0] = painted(pane, 200, 100));
        double ground = brightness(StageColors.now().ground());
        double text = brightness(pane.getForeground());
        double farthest = 0;
        for (int y = 0; y < 100; y++)
            for (int x = 0; x < 200; x++)
                farthest =
                        Math.max(
                                farthest,
                                Math.abs(brightness(new Color(made[0].getRGB(x, y))) - ground));
        assertEquals(Math.abs(text - ground), farthest, 0.2);
    }

    private static double brightness(Color color) {
        return (color.getRed() + color.getGreen() + color.getBlue()) / 765.0;
    }

    @Test
    @DisplayName("formulas keep their size when the type grows")
    void formulasGrowWithTheType() throws Exception {
        double usual = width(settled("$x + 1$", LabTheme.LIGHT, 100));
        double larger = width(settled("$x + 1$", LabTheme.LIGHT, 150));
        assertEquals(1.5, larger / usual, 0.1);
    }

    @Test
    @DisplayName("lines with formulas lie farther apart than lines without")
    void aFormulaFitsItsLine() throws Exception {
        int plain = height(settled("one line", LabTheme.LIGHT, 100));
        for (String formula : List.of("$x$", "$(x_0, y_1)$", "$|\\Delta y|$", "$2^{30}$"))
            assertEquals(plain, height(settled("one " + formula, LabTheme.LIGHT, 100)), formula);
        int fraction = height(settled("$$\n\\frac{a}{b}\n$$", LabTheme.LIGHT, 100));
        assertTrue(fraction > plain + 10, fraction + " beside " + plain);
    }

    @Test
    @DisplayName("a wide formula makes the lines of text longer than the pane")
    void aWideFormulaShrinks() throws Exception {
        String wide = "$$\n" + "x_1 + ".repeat(17) + "x\n$$";
        StatementPane pane = settled(wide, LabTheme.LIGHT, 100);
        EventQueue.invokeAndWait(
                () -> {
                    assertTrue(width(pane) > 500, "wide is " + width(pane));
                    assertTrue(pane.getMinimumSize().width < 500, pane.getMinimumSize().toString());
                    BufferedImage image = painted(pane, 500, 100);
                    assertTrue(lowest(image, 400, 480) > 0, "the end is not in sight");
                    assertEquals(-1, lowest(image, 490, 500), "something is cut");
                });
    }

    @Test
    @DisplayName("a selected formula is as dark as the selection")
    void aSelectedFormulaHasTheColorOfSelectedText() throws Exception {
        StatementPane pane = settled("$\\boxed{E}$", LabTheme.LIGHT, 200);
        EventQueue.invokeAndWait(
                () -> {
                    pane.selectAll();
                    pane.getCaret().setSelectionVisible(true);
                    BufferedImage image = painted(pane, 100, 60);
                    Color marked = pane.getSelectionColor();
                    int x = (int) typeset(pane).get(0).getPreferredSpan(View.X_AXIS);
                    int found = 0;
                    for (int y = 0; y < 60; y++)
                        for (int at = 0; at < x; at++)
                            if (image.getRGB(at, y) == marked.getRGB()) found++;
                    assertTrue(found > 50, "nothing is marked");
                    assertEquals(-1, lowest(image, 0, 100, 0.2), "dark on the mark");
                });
    }

    @Test
    @DisplayName("a formula stands below or above its line")
    void aFormulaStandsOnTheLine() throws Exception {
        StatementPane pane = settled("E$E$", LabTheme.LIGHT, 200);
        EventQueue.invokeAndWait(
                () -> {
                    BufferedImage image = painted(pane, 100, 60);
                    int middle = middle(pane);
                    assertEquals(lowest(image, 0, middle), lowest(image, middle, 100), 1);
                });
    }

    /** Where the formula begins. */
    private static int middle(StatementPane pane) {
        try {
            return (int) pane.modelToView2D(text(pane).indexOf("$")).getX();
        } catch (javax.swing.text.BadLocationException e) {
            throw new AssertionError("the position is one of the text's", e);
        }
    }

    private static BufferedImage painted(StatementPane pane, int width, int height) {
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        pane.setSize(width, height);
        var g = image.createGraphics();
        pane.paint(g);
        g.dispose();
        return image;
    }

    private static int lowest(BufferedImage image, int from, int to) {
        return lowest(image, from, to, 0.5);
    }

    /** The lowest row with a pixel darker than that, or -1. */
    private static int lowest(BufferedImage image, int from, int to, double dark) {
        for (int y = image.getHeight() - 1; y >= 0; y--)
            for (int x = from; x < to; x++)
                if (brightness(new Color(image.getRGB(x, y))) < dark) return y;
        return -1;
    }

    @Test
    @DisplayName("a broken formula takes the statement with it")
    void aBrokenFormulaLeavesTheRest() throws Exception {
        StatementPane pane = settled("Let $\\foo$ be $x$.", LabTheme.LIGHT, 100);
        String text = text(pane);
        assertTrue(
                text.contains("$\\foo$ (\\foo is not a command that is known here) be $x$."), text);
        assertEquals(1, typeset(pane).size());
    }

    @Test
    @DisplayName("a formula and the comma after it part at a line's end")
    void aCommaStaysWithItsFormula() throws Exception {
        StatementPane pane = settled("$x$, $y$ z", LabTheme.LIGHT, 100);
        List<View> views = typeset(pane);
        assertEquals(View.BadBreakWeight, views.get(0).getBreakWeight(View.X_AXIS, 0, 1000));
        assertFalse(views.get(1).getBreakWeight(View.X_AXIS, 0, 1000) == View.BadBreakWeight);
    }

    private StatementPane settled(String markdown, LabTheme theme, int percent) throws Exception {
        var pane = new StatementPane[1];
        EventQueue.invokeAndWait(
                () -> {
                    theme.install(percent);
                    pane[0] = new StatementPane("Statement", formulas, failures::add);
                    pane[0].setSize(500, 200);
                    pane[0].show(saying(markdown), "en", "");
                });
        pane[0].settle();
        return pane[0];
    }

    private static Exercise saying(String markdown) {
        Exercise like = Catalogue.builtIn().all().get(0);
        return new Exercise(
                like.id(),
                like.topic(),
                like.title(),
                Map.of("en", markdown),
                Map.of(),
                like.starter(),
                like.revision(),
                like.tolerance(),
                like.points(),
                like.cases());
    }

    private static String text(StatementPane pane) {
        try {
            return pane.getDocument().getText(0, pane.getDocument().getLength());
        } catch (javax.swing.text.BadLocationException e) {
            throw new AssertionError("the whole document is asked for", e);
        }
    }

    private static double width(StatementPane pane) {
        View formula = typeset(pane).get(0);
        return onEventThread(() -> formula.getPreferredSpan(View.X_AXIS));
    }

    private static List<View> typeset(StatementPane pane) {
        return onEventThread(
                () -> {
                    var found = new ArrayList<View>();
                    View root = pane.getUI().getRootView(pane);
                    root.setSize(500, 1000);
                    collect(root, found);
                    return found;
                });
    }

    /** Views may be asked there alone. */
    private static <T> T onEventThread(Supplier<T> question) {
        if (EventQueue.isDispatchThread()) return question.get();
        var answer = new AtomicReference<T>();
        try {
            EventQueue.invokeAndWait(() -> answer.set(question.get()));
        } catch (InterruptedException | InvocationTargetException e) {
            throw new AssertionError("no answer on the event thread", e);
        }
        return answer.get();
    }

    private static int height(StatementPane pane) {
        return onEventThread(() -> pane.getPreferredSize().height);
    }

    private static void collect(View view, List<View> found) {
        if (view instanceof TypesetView) found.add(view);
        for (int i = 0; i < view.getViewCount(); i++) collect(view.getView(i), found);
    }
}
