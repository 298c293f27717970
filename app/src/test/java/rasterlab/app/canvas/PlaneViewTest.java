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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class PlaneViewTest {
    private static final Dimension STAGE = new Dimension(380, 270);

    private record Empty(boolean ruled) implements PlanePicture {
        @Override
        public void paint(
                Graphics2D g, PlaneMap map, StageColours colours, BooleanSupplier cancelled) {}
    }

    @ParameterizedTest(name = "the note covers the handle at ({0}, {1}), with rulers: {2}")
    @CsvSource({"5, 99, true", "5, 99, false", "-99, 99, false"})
    void handleBeyondTheEdgeIsBesideTheNote(double x, double y, boolean ruled) {
        var failures = new CopyOnWriteArrayList<Throwable>();
        Texts texts = Texts.of("canvas", Language.ENGLISH);
        var scene = new Empty(ruled);
        String said = "many words ".repeat(12).strip();
        var point = new PlanePoint("point.0", x, y, PlanePoint.Form.CIRCLE, "", "");
        try (var view =
                new PlaneView(
                        PlaneAxes.GEOMETRY, texts, "", new NoEdits(), () -> {}, failures::add)) {
            view.show(scene, List.of(point), said, new Rectangle2D.Double(0, 0, 10, 10), 1);
            view.setSize(STAGE);
            view.doLayout();
            Rectangle sight =
                    PlaneFrame.note(scene, said, STAGE, UIManager.getFont("Label.font")).below();
            Rectangle handle =
                    Stream.of(view.getComponents())
                            .filter(each -> "point.0".equals(each.getName()))
                            .findFirst()
                            .map(Component::getBounds)
                            .orElseThrow();
            assertEquals(sight.y, handle.y);
            assertTrue(sight.contains(handle), handle + " not in " + sight);
            if (x < 0) assertEquals(sight.x, handle.x);
        }
        assertEquals(List.of(), failures);
    }
}
