package rasterlab.app.line.figure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseWheelEvent;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.Parts;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineMode;
import rasterlab.engine.circle.Circle;

@Timeout(300)
class FigureStageTest {
    private static final Dimension SIZE = new Dimension(800, 600);

    /** Rulers and a handle are narrower. */
    private static final int EDGE = 60;

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final FigureLabModel model = new FigureLabModel(thread, failures::add);
    private final FigureStage stage =
            new FigureStage(model, Texts.of("line", Language.ENGLISH), failures::add);

    @BeforeEach
    void listen() {
        model.listen(state -> stage.refresh());
        layOut();
    }

    @AfterEach
    void close() {
        stage.close();
        model.close();
        assertEquals(List.of(), failures);
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("typed")
    void sightFollowsANumberThatIsTyped(LineMode mode, UnaryOperator<ArcFigure> typed) {
        model.chooseMode(mode);
        thread.settle(model::settle);
        typed(typed);
        assertSeen();
        model.history().undo();
        thread.settle(model::settle);
        layOut();
        assertSeen();
    }

    static Stream<Arguments> typed() {
        UnaryOperator<ArcFigure> far = old -> old.withCenter(1_000_000, old.centerY());
        UnaryOperator<ArcFigure> large = old -> old.withRadiusX(5_000);
        UnaryOperator<ArcFigure> tall = old -> old.withRadiusY(5_000);
        return Stream.of(
                argumentSet("a circle far away is not seen", LineMode.CIRCLE, far),
                argumentSet("a large circle is not seen", LineMode.CIRCLE, large),
                argumentSet("an ellipse far away is not seen", LineMode.ELLIPSE, far),
                argumentSet("a tall ellipse is not seen", LineMode.ELLIPSE, tall));
    }

    @Test
    void sightThatWasChosenStaysAsLongAsTheFigureIsInIt() {
        zoomOut(3);
        Rectangle before = handle(ArcFigure.CENTER);
        typed(old -> old.withRadiusX(12));
        assertEquals(before, handle(ArcFigure.CENTER));
        typed(old -> old.withRadiusX(5_000));
        assertSeen();
        zoomOut(3);
        typed(old -> old.withCenter(1_000_000, 0));
        assertSeen();
    }

    @ParameterizedTest(name = "the grid of a circle of radius {0} counts parts of pixels")
    @ValueSource(ints = {0, 1, 2, 3, 40, 5_000})
    void gridOfACircleCountsWholePixels(int radius) {
        model.show(new Circle(0, 0, radius));
        thread.settle(model::settle);
        layOut();
        List<String> numbers =
                Pattern.compile(">(−?[\\d.,]+)</text")
                        .matcher(stage.svg().document())
                        .results()
                        .map(found -> found.group(1))
                        .toList();
        assertTrue(numbers.size() > 4, numbers.toString());
        for (String number : numbers)
            assertTrue(number.matches("−?(\\d+|\\d{1,3}(,\\d{3})+)"), numbers.toString());
    }

    private void zoomOut(int notches) {
        var view = (PlaneView) named(stage, "stage");
        view.dispatchEvent(
                new MouseWheelEvent(
                        view,
                        MouseWheelEvent.MOUSE_WHEEL,
                        0,
                        0,
                        300,
                        300,
                        0,
                        false,
                        0,
                        1,
                        notches));
        layOut();
    }

    private void typed(UnaryOperator<ArcFigure> changed) {
        model.arc(changed);
        thread.settle(model::settle);
        layOut();
    }

    private void layOut() {
        stage.setSize(SIZE);
        layOut(stage);
    }

    private static void layOut(Container parent) {
        parent.doLayout();
        for (var child : parent.getComponents()) if (child instanceof Container c) layOut(c);
    }

    /** Handles of what is out of sight stay at the edge. */
    private void assertSeen() {
        for (String grip : model.state().scene().figure().grips().keySet()) {
            Rectangle handle = handle(grip);
            var middle = new Point((int) handle.getCenterX(), (int) handle.getCenterY());
            var inside = new Rectangle(SIZE);
            inside.grow(-EDGE, -EDGE);
            assertTrue(inside.contains(middle), grip + " at " + middle);
        }
        int apart =
                handle(ArcFigure.RADIUS_X).x
                        - handle(ArcFigure.CENTER).x
                        + handle(largerRadius()).y
                        - handle(ArcFigure.CENTER).y;
        assertTrue(apart > 100, "the figure is a spot of " + apart + " view units");
    }

    private String largerRadius() {
        return model.state().scene().mode() == LineMode.CIRCLE
                ? ArcFigure.CENTER
                : ArcFigure.RADIUS_Y;
    }

    private Rectangle handle(String grip) {
        return named((Container) named(stage, "stage"), grip).getBounds();
    }

    private static Component named(Container parent, String name) {
        return Parts.of(parent)
                .filter(part -> name.equals(part.getName()))
                .findFirst()
                .orElseThrow(() -> new AssertionError("no " + name));
    }
}
