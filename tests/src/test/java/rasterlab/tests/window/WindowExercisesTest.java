package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.text.JTextComponent;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rsyntaxtextarea.TokenTypes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.line.Segment;
import rasterlab.tests.bench.window.WindowContent;
import rasterlab.tests.grading.Solutions;

/** The tab of exercises under a real display, by mouse and keyboard. */
@Timeout(300)
class WindowExercisesTest extends ExercisesHarness {
    private String source() {
        return window.textBox("source").text();
    }

    private String verdict() {
        return window.label("result.verdict").text();
    }

    private void awaitVerdict(String words) {
        await("the verdict is " + words, () -> verdict().contains(words));
        robot.waitForIdle();
    }

    private Path draft() {
        return folder.resolve("drafts").resolve("line-bresenham.java");
    }

    private String drafted() {
        try {
            return Files.exists(draft()) ? Files.readString(draft()) : "";
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void wrongSolutionIsShownItsCaseAndOpensItInTheTabOfLines() {
        type(Solutions.source(Solutions.WRONG));
        window.button("check").click();
        awaitVerdict("wrong");
        assertTrue(window.textBox("reason").text().contains("(4, 3)"));
        window.comboBox("view").selectItem(4);
        window.comboBox("view").selectItem(0);
        window.button("open").click();
        robot.waitForIdle();
        assertEquals("line", WindowContent.of(frame).shown());
        assertEquals(new Segment(4, 3, 4, 3), segment());
        await(
                "the program's pixels beside the right ones",
                () -> models.of(new LineRoom()).state().other().isPresent());
    }

    @Test
    void eachCaseOfTheTableIsExplained() {
        type(Solutions.source(Solutions.WRONG));
        focus("source");
        robot.pressKey(KeyEvent.VK_CONTROL);
        press(KeyEvent.VK_ENTER);
        robot.releaseKey(KeyEvent.VK_CONTROL);
        awaitVerdict("wrong");
        window.table("cases").selectRows(1);
        robot.waitForIdle();
        String first = window.textBox("reason").text();
        press(KeyEvent.VK_UP);
        assertTrue(!window.textBox("reason").text().equals(first), first);
    }

    @Test
    void sourceIsMeasuredInTheTypeThatItIsShownIn() {
        show("line");
        GuiActionRunner.execute(() -> frame.wear(frame.look().larger()));
        show("exercises");
        var editor = window.textBox("source").targetCastedTo(RSyntaxTextArea.class);
        int shown = GuiActionRunner.execute(() -> editor.getFont().getSize());
        int measured =
                GuiActionRunner.execute(
                        () ->
                                editor.getFontMetricsForTokenType(TokenTypes.IDENTIFIER)
                                        .getFont()
                                        .getSize());
        assertEquals(shown, measured);
    }

    @Test
    void remarkLeadsToItsLine() {
        type(Solutions.source(Solutions.FORBIDDEN));
        window.button("check").click();
        awaitVerdict("not accepted");
        window.list("remarks").clickItem(0);
        robot.waitForIdle();
        var editor = window.textBox("source").target();
        int caret = GuiActionRunner.execute(editor::getCaretPosition);
        assertEquals(6, source().substring(0, caret).chars().filter(c -> c == '\n').count());
        assertTrue(GuiActionRunner.execute(editor::isFocusOwner), "the editor has no keyboard");
    }

    @Test
    void typedKeysAreKeptAsTheyAreTyped() {
        focus("source");
        press(KeyEvent.VK_X);
        await("the draft is on the disk", () -> drafted().startsWith("x"));
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals("exercises", WindowContent.of(frame).shown());
        assertTrue(source().startsWith("x"), source());
    }

    @Test
    void editorOutOfSightDoesNotGoOnBlinking() {
        focus("source");
        JTextComponent editor = editor();
        show("line");
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        robot.waitForIdle();
        assertEquals(0, GuiActionRunner.execute(() -> editor.getCaret().getBlinkRate()));
        show("exercises");
        assertTrue(GuiActionRunner.execute(() -> editor().getCaret().getBlinkRate()) > 0);
    }

    private JTextComponent editor() {
        return window.textBox("source").targetCastedTo(JTextComponent.class);
    }

    /** Caret, selection and scroll of the editor. */
    private List<Integer> place() {
        robot.waitForIdle();
        return GuiActionRunner.execute(
                () ->
                        List.of(
                                editor().getCaret().getMark(),
                                editor().getCaretPosition(),
                                editor().getVisibleRect().y));
    }

    private List<Integer> typeAndSelectFarBelow(String text) {
        type(text);
        focus("source");
        // a source that does not compile would be checked in no time
        press(KeyEvent.VK_SPACE);
        assertEquals(" " + text, source());
        GuiActionRunner.execute(
                () -> {
                    int end = editor().getDocument().getLength() * 3 / 4;
                    editor().select(end - 7, end - 2);
                });
        assertTrue(place().get(2) > 0, "all is in sight");
        return place();
    }

    @ParameterizedTest(name = "undo, caret, selection or scroll is lost by another {0}")
    @ValueSource(strings = {"spoken language", "chosen language", "theme"})
    void editorGoesOnAsItWas(String look) {
        String text = source() + "// far below\n".repeat(80);
        List<Integer> place = typeAndSelectFarBelow(text);
        switch (look) {
            case "spoken language" ->
                    GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
            case "chosen language" -> {
                window.comboBox("language").selectItem(Language.RUSSIAN.ordinal());
                await("Russian", () -> frame.language() == Language.RUSSIAN);
            }
            default -> GuiActionRunner.execute(() -> frame.wear(frame.look().with(LabTheme.DARK)));
        }
        assertEquals(place, place());
        window.button("undo").click();
        await("what was before is back", () -> source().equals(text));
        assertTrue(window.button("redo").isEnabled(), "nothing can be done again");
    }

    @Test
    void editorGoesOnAsItWasBesideACheckThatRuns() {
        String text = Solutions.source(Solutions.ENDLESS) + "// far below\n".repeat(80);
        List<Integer> place = typeAndSelectFarBelow(text);
        window.button("check").click();
        await("it runs", () -> window.button("cancel").isEnabled());
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        assertEquals(place, place());
        assertTrue(window.button("cancel").isEnabled(), "the check is given up");
        window.button("undo").click();
        await("what was before is back", () -> source().equals(text));
        window.button("cancel").click();
        await("it is given up", () -> window.button("check").isEnabled());
    }

    @Test
    void starterComesBackAndCanBeUndone() {
        String starter = source();
        focus("source");
        press(KeyEvent.VK_X);
        restoreStarter("Keep my text");
        assertEquals("x" + starter, source());
        restoreStarter("Replace");
        assertEquals(starter, source());
        window.button("undo").click();
        await("what was before is back", () -> source().equals("x" + starter));
        await("that is kept too", () -> drafted().equals("x" + starter));
        window.button("redo").click();
        robot.waitForIdle();
        assertEquals(starter, source());
    }

    private void restoreStarter(String answer) {
        var button = window.button("starter").target();
        EventQueue.invokeLater(button::doClick);
        choose(answer);
        robot.waitForIdle();
    }

    @Test
    void keyboardIsBackOnCheckWhenItHasRun() {
        type(Solutions.source(Solutions.WRONG));
        window.button("check").click();
        awaitVerdict("wrong");
        assertTrue(hasKeyboard("check"));
    }

    @Test
    void keyboardIsOnTheButtonThatGivesUpWhileWorkRuns() {
        String endless = Solutions.source(Solutions.ENDLESS);
        type(endless);
        window.button("check").click();
        await("it can be given up", () -> hasKeyboard("cancel"));
        press(KeyEvent.VK_SPACE);
        await("it is given up", () -> hasKeyboard("check"));
        assertEquals(endless, source());
    }

    @Test
    void typeGrowsAndShrinks() {
        var editor = window.textBox("source").target();
        int before = GuiActionRunner.execute(() -> editor.getFont().getSize());
        window.button("larger").click();
        window.button("larger").click();
        window.button("smaller").click();
        robot.waitForIdle();
        assertEquals(before + 1, GuiActionRunner.execute(() -> editor.getFont().getSize()));
    }

    @Test
    void cancelledCheckLeavesTheText() {
        String endless = Solutions.source(Solutions.ENDLESS);
        type(endless);
        window.button("check").click();
        await("it runs", () -> window.button("cancel").isEnabled());
        focus("source");
        press(KeyEvent.VK_ESCAPE);
        await("it is given up", () -> window.button("check").isEnabled());
        assertEquals(endless, source());
        assertTrue(window.textBox("notice").text().contains("Cancelled"));
    }

    @Test
    void textThatCannotBeSavedIsAskedForBeforeTheWindowCloses() throws Exception {
        Files.createDirectory(draft());
        Files.writeString(draft().resolve("in-the-way"), "");
        type("typed");
        askToClose();
        JOptionPaneFixture question = window.optionPane();
        assertTrue(messageOf(question).contains("line-bresenham"), messageOf(question));
        press(KeyEvent.VK_ESCAPE);
        assertTrue(frame.isShowing(), "stays");
        assertEquals("typed", source());

        askToClose();
        choose("Save elsewhere…");
        Path elsewhere = folder.resolve("kept.java");
        window.fileChooser().fileNameTextBox().setText(elsewhere.toString());
        window.fileChooser().fileNameTextBox().pressAndReleaseKeys(KeyEvent.VK_ENTER);
        await("the window closes", () -> !frame.isDisplayable());
        assertEquals("typed", Files.readString(elsewhere));
    }

    @Test
    void windowClosesWithoutItsTextWhereTheUserSaysSo() throws Exception {
        Files.createDirectory(draft());
        Files.writeString(draft().resolve("in-the-way"), "");
        type("typed");
        askToClose();
        choose("Close anyway");
        await("the window closes", () -> !frame.isDisplayable());
    }

    @Test
    void savedTextIsNotAskedFor() {
        type("typed");
        askToClose();
        await("the window closes", () -> !frame.isDisplayable());
        assertEquals("typed", drafted());
    }

    private void askToClose() {
        EventQueue.invokeLater(
                () -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING)));
    }

    private void choose(String answer) {
        var button = window.optionPane().buttonWithText(answer).target();
        EventQueue.invokeLater(button::doClick);
    }

    private static String messageOf(JOptionPaneFixture question) {
        return GuiActionRunner.execute(() -> question.target().getMessage().toString());
    }
}
