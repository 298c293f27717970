package rasterlab.app.row;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import javax.swing.JEditorPane;
import javax.swing.JLabel;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;

class RowInspectorTest {
    private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final RowLabModel model =
            RowLabModel.ofDepths(new OwnMethods(), answers::add, failures::add);
    private final AtomicReference<RowInspector> inspector = new AtomicReference<>();

    @AfterEach
    void end() {
        model.end();
        assertEquals(List.of(), failures);
    }

    @Test
    void nothingIsSaidOfARowUntilItsAnswerIsThere() throws Exception {
        refreshed();
        assertEquals("—", text("verdict.value"));
        assertEquals("—", text("wrong.value"));
        answer();
        refreshed();
        assertFalse(text("verdict.value").equals("—"));
        assertFalse(text("wrong.value").equals("—"));
        assertFalse(numbers().contains("—"), numbers());

        model.show("depth-buffer", "drift-8192", "z16");
        refreshed();
        assertEquals("—", text("verdict.value"), "the verdict of the row before");
        assertEquals("—", text("wrong.value"), "the wrong pixels of the row before");
        assertTrue(numbers().contains("—"), numbers());
        assertFalse(numbers().matches("(?s).*\\d\\.\\d.*"), "numbers of the row before");
        answer();
        refreshed();
        assertFalse(text("verdict.value").equals("—"));
        assertFalse(numbers().contains("—"), numbers());
    }

    @ParameterizedTest(name = "the list that leads to the rows has another name among them: {0}")
    @EnumSource
    void listOfTopicsHasOneName(Language language) {
        String here = Texts.of("row", language).label("mode");
        for (String tab : List.of("visibility", "light"))
            assertEquals(Texts.of(tab, language).label("mode"), here, tab);
    }

    private void refreshed() throws InterruptedException, InvocationTargetException {
        EventQueue.invokeAndWait(
                () -> {
                    if (inspector.get() == null) inspector.set(made());
                    inspector.get().refresh();
                });
    }

    private RowInspector made() {
        return new RowInspector(
                model,
                Texts.of("row", Language.ENGLISH),
                Texts.of("visibility", Language.ENGLISH),
                List.of("depth-buffer"),
                mode -> {});
    }

    private void answer() throws InterruptedException {
        model.settle();
        for (Runnable each = answers.poll(); each != null; each = answers.poll()) each.run();
    }

    private String text(String name) {
        return ((JLabel) named(inspector.get().column(), name).orElseThrow()).getText();
    }

    /** The table's words, without the marks around them. */
    private String numbers() {
        var table = (JEditorPane) named(inspector.get().column(), "numbers").orElseThrow();
        return table.getText().replace("&#8212;", "—").replaceAll("<[^>]*>|&[^;]*;", " ");
    }

    private static Optional<Component> named(Container container, String name) {
        return Stream.of(container.getComponents())
                .flatMap(
                        each ->
                                name.equals(each.getName())
                                        ? Stream.of(each)
                                        : each instanceof Container inner
                                                ? named(inner, name).stream()
                                                : Stream.empty())
                .findFirst();
    }
}
