package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.clip.ClipLabModel;
import rasterlab.app.clip.ClipMode;
import rasterlab.app.coordinates.CoordinatesLabModel;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.list.Example;
import rasterlab.app.coordinates.stack.StackProgram;
import rasterlab.app.coordinates.view.ViewKind;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineMode;
import rasterlab.app.opengl.state.Group;
import rasterlab.app.polygon.PolygonLabModel;
import rasterlab.app.polygon.PolygonMode;
import rasterlab.app.spline.CurveForm;
import rasterlab.app.spline.Sampling;
import rasterlab.app.spline.SplineLabModel;
import rasterlab.app.spline.SplineMode;
import rasterlab.contract.SplineEnds;

class ClippedTextTest {
    /** What else the tab of splines shows, each with texts of its own. */
    private static final List<Consumer<SplineLabModel>> OTHER_SPLINES =
            List.of(
                    model -> model.curve().chooseForm(CurveForm.PIECES),
                    model -> model.curve().compareWith("adaptive-naive"),
                    model -> model.curve().chooseForm(CurveForm.B_SPLINE),
                    model -> model.curve().sample(Sampling.equal(9)),
                    model -> model.curve().show(model.curve().hazards().get(4).input()),
                    model -> model.show(SplineMode.FUNCTION),
                    model -> model.function().chooseEnds(SplineEnds.slopes(-1.25, 3)),
                    model -> model.function().chooseMethod("monotone"),
                    model -> model.function().show(model.function().hazards().get(0).input()));

    /** What else the tab of coordinates shows, each with texts of its own. */
    private static final List<Consumer<CoordinatesLabModel>> OTHER_COORDINATES =
            List.of(
                    model -> model.views().goTo(model.views().last()),
                    model -> model.views().goTo(2),
                    model -> model.views().choose(ViewKind.SPHERICAL_LEFT),
                    model -> model.views().choose(ViewKind.LOOK_AT),
                    model -> model.show(CoordinatesMode.TRANSFORMATIONS),
                    model -> model.transformations().show(Example.AXIS),
                    model -> model.transformations().show(Example.PROJECTIVE),
                    model -> model.show(CoordinatesMode.STACK),
                    model -> model.stack().show(StackProgram.LOADED),
                    model -> model.stack().goTo(1),
                    model -> model.show(CoordinatesMode.ROTATION),
                    model -> model.rotation().chooseMethod("buneman-textbook"),
                    model -> model.show(CoordinatesMode.MEETING));

    @AfterAll
    static void typeIsOfUsualSizeAgain() throws InterruptedException {
        OffscreenPainter.onEventThread(LabTheme.LIGHT::install);
    }

    static Stream<Arguments> sizes() {
        return Stream.of(Language.values())
                .flatMap(
                        language ->
                                Stream.of(
                                        Arguments.of(language, LabTheme.LIGHT, 100, 900, 560),
                                        Arguments.of(language, LabTheme.LIGHT, 100, 1280, 680),
                                        Arguments.of(language, LabTheme.LIGHT, 100, 2560, 1380),
                                        Arguments.of(language, LabTheme.LIGHT, 150, 900, 560),
                                        Arguments.of(language, LabTheme.LIGHT, 150, 1280, 680),
                                        Arguments.of(language, LabTheme.PROJECTOR, 100, 900, 560),
                                        Arguments.of(
                                                language, LabTheme.PROJECTOR, 100, 1280, 680)));
    }

    /** What else a tab shows, with texts of its own. */
    private record Other(String tab, String name, Consumer<LabModels> change) {}

    private static List<Other> others() {
        var others = new ArrayList<Other>();
        for (Consumer<SplineLabModel> each : OTHER_SPLINES)
            others.add(new Other("spline", "curve", models -> each.accept(models.spline())));
        for (Consumer<CoordinatesLabModel> each : OTHER_COORDINATES)
            others.add(new Other("coordinates", "", models -> each.accept(models.coordinates())));
        for (Group each : Group.values())
            others.add(
                    new Other(
                            "opengl",
                            each.name(),
                            models -> models.opengl().touch(each.settings().get(0))));
        for (ClipMode each : ClipMode.values())
            others.add(new Other("clip", each.name(), m -> showComparison(m.clip(), each)));
        for (LineMode each : LineMode.values())
            others.add(new Other("line", each.name(), m -> m.line().chooseMode(each)));
        for (PolygonMode each : PolygonMode.values())
            others.add(new Other("polygon", each.name(), m -> showComparison(m.polygon(), each)));
        others.add(
                new Other(
                        "visibility",
                        "everything",
                        models -> {
                            models.visibility().compare("globe", "newell", "z24");
                            models.visibility().watchSteps(true);
                        }));
        others.add(new Other("light", "colours", models -> models.light().showColours(true)));
        others.add(
                new Other(
                        "visibility",
                        "rows",
                        m -> m.visibility().rows().show("depth-buffer", "drift-8192", "z16")));
        for (String topic : List.of("texture-mapping", "texture-filter"))
            others.add(new Other("light", topic, models -> models.light().rows().open(topic)));
        return others;
    }

    @ParameterizedTest(name = "a label is cut off: {0}, {1}, {2} % in {3}×{4}")
    @MethodSource("sizes")
    void everyTextHasTheWidthItNeeds(
            Language language, LabTheme theme, int textPercent, int width, int height)
            throws InterruptedException {
        var tabs = new AtomicReference<LabTabs>();
        var models = new AtomicReference<LabModels>();
        var failures = new CopyOnWriteArrayList<Throwable>();
        OffscreenPainter.onEventThread(
                () -> {
                    theme.install(textPercent);
                    models.set(LabModels.first(failures::add));
                    models.get().line().compareWith("naive-textbook");
                    tabs.set(LabTabs.create(models.get(), language, failures::add));
                    tabs.get().all().forEach(LabTab::panel);
                });
        for (LabTab tab : tabs.get().all()) {
            OffscreenPainter.paint(tab.panel(), width, height);
            assertEquals(List.of(), clipped(tab.panel()), tab.name());
        }
        for (Other other : others()) {
            JComponent panel = tabs.get().named(other.tab()).panel();
            OffscreenPainter.onEventThread(() -> other.change().accept(models.get()));
            for (int round = 0; round < 2; round++) OffscreenPainter.paint(panel, width, height);
            assertEquals(List.of(), clipped(panel), other.tab() + ": " + other.name());
        }
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.get().close();
                    models.get().close();
                });
        assertEquals(List.of(), failures, "what a lab could not do");
    }

    /** As many rows in the inspector as there can be. */
    private static void showComparison(ClipLabModel clip, ClipMode mode) {
        clip.chooseMode(mode);
        clip.compareWith(clip.state().choice().scene().method());
        clip.goTo(1);
    }

    private static void showComparison(PolygonLabModel polygon, PolygonMode mode) {
        polygon.chooseMode(mode);
        polygon.compareWith(polygon.state().choice().scene().method());
        polygon.goTo(1);
    }

    private static List<String> clipped(Container container) {
        var found = new ArrayList<String>();
        for (Component child : container.getComponents()) {
            if (!child.isVisible()) continue;
            CutText.of(child).ifPresent(found::add);
            if (child instanceof Container inner && !(child instanceof JComboBox))
                found.addAll(clipped(inner));
        }
        return found;
    }
}
