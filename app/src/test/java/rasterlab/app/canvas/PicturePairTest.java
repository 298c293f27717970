package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class PicturePairTest {
    private static final Rectangle2D ALL = new Rectangle2D.Double(0, 0, 10, 10);

    private final List<Throwable> failures = new ArrayList<>();

    @Test
    @DisplayName("the drawing of two pictures has one of them, or one that is not shown")
    void svgHasBothPictures() {
        try (var pair = new PicturePair(view("first method"), view("second method"))) {
            pair.setSize(900, 400);
            pair.arrange(ALL, true);
            pair.doLayout();
            String two = pair.svg().document();
            assertTrue(two.contains("first method"), two);
            assertTrue(two.contains("second method"), two);
            assertTrue(two.contains("width=\"900\""), two);
            pair.arrange(ALL, false);
            pair.doLayout();
            String one = pair.svg().document();
            assertTrue(one.contains("first method"), one);
            assertFalse(one.contains("second method"), one);
        }
        assertEquals(List.of(), failures);
    }

    private PlaneView view(String note) {
        Texts texts = Texts.of("canvas", Language.ENGLISH);
        var view =
                new PlaneView(
                        PlaneAxes.GEOMETRY, texts, note, new NoEdits(), () -> {}, failures::add);
        view.show((g, map, colors, cancelled) -> {}, List.of(), note, ALL, 1);
        return view;
    }
}
