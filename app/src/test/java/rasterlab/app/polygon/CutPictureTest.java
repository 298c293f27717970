package rasterlab.app.polygon;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Point;
import java.awt.Rectangle;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.polygon.figure.CornerList;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.outcome.CutAnswer;
import rasterlab.app.polygon.outcome.CutAnswer.CutTriangle;
import rasterlab.app.polygon.outcome.CutAnswer.TriangleFault;

class CutPictureTest {
    private static final int SIZE = 400;

    /** Where the number's text begins: its base line's left end. */
    private static Point number(List<Rectangle> labels) {
        var figure = new CutFigure(CornerList.of(0, 0, 30, 0, 0, 30));
        var cut = new CutAnswer(List.of(new CutTriangle(0, 1, 2, 1, TriangleFault.NONE)), 1);
        PlanePicture picture =
                new CutPicture(figure, "fan", cut, List.of(), "", 1, List.of()).leaving(labels);
        var map = new PlaneMap(50, 350, 10, -10);
        String svg =
                SvgPicture.of(
                                SIZE,
                                SIZE,
                                g -> picture.paint(g, map, StageColors.LIGHT, () -> false))
                        .document();
        return Pattern.compile("<text[^>]*? x=\"(\\d+)\"[^>]*? y=\"(\\d+)\"[^>]*>1<")
                .matcher(svg)
                .results()
                .map(
                        text ->
                                new Point(
                                        Integer.parseInt(text.group(1)),
                                        Integer.parseInt(text.group(2))))
                .findFirst()
                .orElseThrow();
    }

    @Test
    @DisplayName("the number of a triangle lies on a corner's name")
    void numberKeepsOffNamesWhereThereIsRoom() {
        var name = new Rectangle(130, 230, 40, 40);
        assertFalse(name.contains(number(List.of(name))), number(List.of(name)).toString());
    }

    @Test
    @DisplayName("a triangle has no number, or one elsewhere, where names leave no room")
    void numberStandsInTheMiddleWhereNamesAreEverywhere() {
        assertEquals(number(List.of()), number(List.of(new Rectangle(0, 0, SIZE, SIZE))));
    }
}
