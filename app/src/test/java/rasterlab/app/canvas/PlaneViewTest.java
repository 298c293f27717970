package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.swing.UIManager;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class PlaneViewTest {
    private static final Dimension STAGE = new Dimension(380, 270);

    private record Empty(boolean ruled) implements PlanePicture {
        @Override
        public void paint(
                Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {}
    }

    @ParameterizedTest(name = "the note covers the handle at ({0}, {1}), with rulers: {2}")
    @CsvSource({"5, 99, true", "5, 99, false", "-99, 99, false"})
    void handleBeyondTheEdgeIsBesideTheNote(double x, double y, boolean ruled) {
        var failures = new CopyOnWriteArrayList<Throwable>();
        Texts texts = Texts.of("canvas", Language.ENGLISH);
        var scene = new Empty(ruled);
        String said = "many words ".repeat(12).strip();
        var point = new PlanePoint("point.0", x, y, PlanePoint.HandleShape.CIRCLE, "", "");
        try (var view =
                new PlaneView(
                        PlaneAxes.GEOMETRY, texts, "", new NoEdits(), () -> {}, failures::add)) {
            view.show(scene, List.of(point), said, new Rectangle2D.Double(0, 0, 10, 10), 1);
            view.setSize(STAGE);
            view.doLayout();
            Rectangle sight =
                    PlaneFrame.note(scene, said, STAGE, UIManager.getFont("Label.font")).below();
            Rectangle handle = part(view, "point.0");
            assertEquals(sight.y, handle.y);
            assertTrue(sight.contains(handle), handle + " not in " + sight);
            if (x < 0) assertEquals(sight.x, handle.x);
        }
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("handles change places, or one that is out of sight lies under the buttons")
    void handlesLieAroundTheirPointsAndClearOfTheButtons() {
        var failures = new CopyOnWriteArrayList<Throwable>();
        var seen = new PlanePoint("seen", 5, 5, PlanePoint.HandleShape.CIRCLE, "", "");
        var beyond = new PlanePoint("beyond", 99, -99, PlanePoint.HandleShape.CIRCLE, "", "");
        try (var view =
                new PlaneView(
                        PlaneAxes.GEOMETRY,
                        Texts.of("canvas", Language.ENGLISH),
                        "",
                        new NoEdits(),
                        () -> {},
                        failures::add)) {
            var all = new Rectangle2D.Double(0, 0, 10, 10);
            view.show(new Empty(true), List.of(seen, beyond), "", all, 1);
            view.setSize(STAGE);
            view.doLayout();
            Rectangle inside = Rulers.inside(STAGE);
            assertEquals(inside.getCenterX(), part(view, "seen").getCenterX(), 1);
            assertEquals(inside.getCenterY(), part(view, "seen").getCenterY(), 1);
            Rectangle buttons =
                    Stream.of(view.getComponents())
                            .filter(ZoomButtons.class::isInstance)
                            .findFirst()
                            .map(Component::getBounds)
                            .orElseThrow();
            Rectangle aside = part(view, "beyond");
            assertEquals(inside.x + inside.width, aside.x + aside.width, "at the edge");
            assertEquals(buttons.y, aside.y + aside.height, "above the buttons");
        }
        assertEquals(List.of(), failures);
    }

    private static Rectangle part(PlaneView view, String name) {
        return Stream.of(view.getComponents())
                .filter(each -> name.equals(each.getName()))
                .findFirst()
                .map(Component::getBounds)
                .orElseThrow();
    }
}
