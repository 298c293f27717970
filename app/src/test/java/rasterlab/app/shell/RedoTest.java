package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.work.History;
import rasterlab.app.clip.ClipRoom;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.language.Language;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineRoom;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.opengl.GlView;
import rasterlab.app.opengl.OpenGlRoom;
import rasterlab.app.polygon.PolygonRoom;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.tab.LabTab;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.VisibilityRoom;

/** Checks that each lab's redo restores the choice. */
class RedoTest {
    private static final String FIRST = " forgets what was undone";

    static Stream<Arguments> labs() {
        return Stream.of(
                lab(
                        "coordinates.views",
                        models -> models.of(new CoordinatesRoom()).views().history(),
                        models -> models.of(new CoordinatesRoom()).views().turnBy(10, 5)),
                lab(
                        "coordinates.transformations",
                        models -> models.of(new CoordinatesRoom()).transformations().history(),
                        models -> models.of(new CoordinatesRoom()).transformations().remove()),
                lab(
                        "coordinates.stack",
                        models -> models.of(new CoordinatesRoom()).stack().history(),
                        models -> models.of(new CoordinatesRoom()).stack().clear()),
                lab(
                        "coordinates.rotation",
                        models -> models.of(new CoordinatesRoom()).rotation().history(),
                        models -> models.of(new CoordinatesRoom()).rotation().movePoint(0.5, 0.25)),
                lab(
                        "coordinates.meeting",
                        models -> models.of(new CoordinatesRoom()).meeting().history(),
                        models ->
                                models.of(new CoordinatesRoom())
                                        .meeting()
                                        .chooseMethod("unrounded")),
                lab(
                        "line",
                        models -> models.of(new LineRoom()).history(),
                        models -> models.of(new LineRoom()).chooseMethod("wu")),
                lab(
                        "line.figures",
                        models -> models.of(new LineRoom()).figures().history(),
                        models -> models.of(new LineRoom()).figures().chooseMode(LineMode.ELLIPSE)),
                lab(
                        "polygon",
                        models -> models.of(new PolygonRoom()).history(),
                        models -> models.of(new PolygonRoom()).chooseMode(PolygonMode.values()[1])),
                lab(
                        "clip",
                        models -> models.of(new ClipRoom()).history(),
                        models -> models.of(new ClipRoom()).chooseMode(ClipMode.POLYGON)),
                lab(
                        "visibility",
                        models -> models.of(new VisibilityRoom()).history(),
                        models -> models.of(new VisibilityRoom()).turn(0.1, 0.2)),
                lab(
                        "light",
                        models -> models.of(new LightRoom()).history(),
                        models -> models.of(new LightRoom()).showColors(true)),
                lab(
                        "visibility.rows",
                        models -> models.of(new VisibilityRoom()).rows().history(),
                        models -> models.of(new VisibilityRoom()).rows().chooseMethod("z24")),
                lab(
                        "light.rows",
                        models -> models.of(new LightRoom()).rows().history(),
                        models -> models.of(new LightRoom()).rows().chooseMethod("perspective")),
                lab(
                        "spline.curve",
                        models -> models.of(new SplineRoom()).curve().history(),
                        models -> models.of(new SplineRoom()).curve().chooseForm(CurveForm.PIECES)),
                lab(
                        "spline.function",
                        models -> models.of(new SplineRoom()).function().history(),
                        models -> models.of(new SplineRoom()).function().move(1, 1.2, 0.4)),
                lab(
                        "opengl",
                        models -> models.of(new OpenGlRoom()).history(),
                        models -> models.of(new OpenGlRoom()).show(GlView.values()[1])));
    }

    private static Arguments lab(
            String name, Function<LabModels, History<?>> history, Consumer<LabModels> change) {
        return argumentSet(name + FIRST, name, history, change);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("labs")
    void redoBringsBackWhatWasUndone(
            String name, Function<LabModels, History<?>> historyOf, Consumer<LabModels> change)
            throws InterruptedException {
        withModels(
                models -> {
                    Kept<?> lab = models.kept().get(name);
                    History<?> history = historyOf.apply(models);
                    Object before = lab.kept();
                    change.accept(models);
                    Object after = lab.kept();
                    assertNotEquals(before, after, "the change");
                    history.undo();
                    assertEquals(before, lab.kept(), "after undo");
                    history.redo();
                    assertEquals(after, lab.kept(), "after redo");
                    history.undo();
                    change.accept(models);
                    assertFalse(history.redoable(), "redoable after a new change");
                });
    }

    @Test
    @DisplayName("a tab shows undo without redo, or without redo's keys")
    void eachTabWithUndoHasRedo() throws InterruptedException {
        withModels(
                models -> {
                    try (LabTabs tabs = LabTabs.create(models, Language.ENGLISH, RedoTest::fail)) {
                        for (LabTab tab : tabs.all()) {
                            List<String> buttons = buttons(tab.panel());
                            long undos = buttons.stream().filter("undo"::equals).count();
                            long redos = buttons.stream().filter("redo"::equals).count();
                            assertEquals(undos, redos, tab.name() + ": " + buttons);
                            if (undos == 0) continue;
                            for (String key : List.of("ctrl Z", "ctrl Y", "ctrl shift Z"))
                                assertTrue(bound(tab.panel(), key), tab.name() + ": " + key);
                        }
                    }
                });
    }

    private static void fail(Throwable cause) {
        throw new AssertionError(cause);
    }

    private static List<String> buttons(Container container) {
        var found = new ArrayList<String>();
        for (Component child : container.getComponents()) {
            if (child instanceof JButton button && button.getName() != null)
                found.add(button.getName());
            if (child instanceof Container inner) found.addAll(buttons(inner));
        }
        return found;
    }

    private static boolean bound(Container container, String key) {
        KeyStroke pressed = KeyStroke.getKeyStroke(key);
        for (Component child : container.getComponents()) {
            if (child instanceof JComponent component
                    && Stream.of(
                                    JComponent.WHEN_FOCUSED,
                                    JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                            .anyMatch(when -> component.getInputMap(when).get(pressed) != null))
                return true;
            if (child instanceof Container inner && bound(inner, key)) return true;
        }
        return container instanceof JComponent component
                && component.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).get(pressed)
                        != null;
    }

    private static void withModels(Consumer<LabModels> check) throws InterruptedException {
        var failure = new AtomicReference<Throwable>();
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    try (LabModels models = LabModels.first(failure::set)) {
                        check.accept(models);
                    }
                });
        assertEquals(null, failure.get());
    }
}
