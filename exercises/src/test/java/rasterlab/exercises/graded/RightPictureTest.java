package rasterlab.exercises.graded;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.Topics;

/** Statements show right answers of each form. */
class RightPictureTest {
    private static final int LIT = 0xFF2B3A4A;
    private static final int PAPER = 0xFFFFFFFF;

    /** The margin for the numbers beside the rows and above the columns. */
    private static final int MARGIN = 26;

    private static JsonNode json(String text) throws IOException {
        return new ObjectMapper().readTree(text.replace('\'', '"'));
    }

    private static BufferedImage picture(String topic, String input, String exact)
            throws IOException {
        var format = Topics.named(topic).format();
        return ImageIO.read(
                new ByteArrayInputStream(
                        new RightPicture(format, json(input), json(exact)).drawn().in("en")));
    }

    /** Whether a dot is orange; edges are blended with what is below. */
    private static boolean isCurve(BufferedImage picture, int x, int y) {
        int rgb = picture.getRGB(x, y);
        return (rgb >> 16 & 0xFF) > 0xB0 && (rgb & 0xFF) < 0x60;
    }

    @Test
    void pixelsAreLitWithTheExactCurveOverThem() throws IOException {
        BufferedImage picture =
                picture(
                        "polygon-fill",
                        "{'polygon':[[0,0],[2,0],[2,2],[0,2]],'rule':'evenodd','size':[3,3]}",
                        "{'pixels':[[0,0],[1,0],[0,1],[1,1]]}");
        int cell = 28;
        assertEquals(MARGIN + 5 * cell + 1, picture.getWidth(), "one pixel around the polygon");
        int[] corner = new int[2];
        for (int column = 0; column < 2; column++)
            corner[column] =
                    picture.getRGB(MARGIN + (column + 2) * cell - 6, MARGIN + 2 * cell - 6);
        assertEquals(LIT, corner[0], "the pixel (0, 0)");
        assertEquals(LIT, corner[1], "the pixel (1, 0)");
        assertEquals(PAPER, picture.getRGB(MARGIN + 4 * cell - 6, MARGIN + 2 * cell - 6), "(2, 0)");
        int middle = MARGIN + cell + cell / 2;
        assertTrue(isCurve(picture, middle + cell, middle), "the upper side, y = 0");
        assertTrue(isCurve(picture, middle + 2 * cell, middle + cell), "the right side");
        assertTrue(isCurve(picture, middle, middle + cell), "the left side, which closes it");
    }

    @Test
    void aGivenPictureIsShownWholeWithItsSeedAndWalls() throws IOException {
        BufferedImage picture =
                picture(
                        "fill",
                        "{'picture':['.#.'],'seed':[0,0],'with':'*','connectivity':4}",
                        "{'picture':['*#.']}");
        int cell = 28;
        int row = MARGIN + cell / 2;
        assertEquals(MARGIN + 3 * cell + 1, picture.getWidth());
        assertEquals(LIT, picture.getRGB(MARGIN + 4, MARGIN + 4), "filled");
        assertTrue(isCurve(picture, MARGIN + cell / 4, row), "the seed's ring");
        assertNotEquals(PAPER, picture.getRGB(MARGIN + cell + cell / 2, row), "the wall's cross");
        assertEquals(PAPER, picture.getRGB(MARGIN + 2 * cell + cell / 2, row), "beyond the wall");
    }

    @Test
    void aLongNumberBesideARowIsWhole() throws IOException {
        BufferedImage near = picture("circle", "{}", "{'pixels':[[0,0]]}");
        BufferedImage far = picture("circle", "{}", "{'pixels':[[0,-123456789]]}");
        assertTrue(far.getWidth() > near.getWidth() + 30, far.getWidth() + " columns");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "clip-segment {'window':[0,0,10,8],'segments':[[0,0,12,8]]} {'segments':[[0,0,10,6]]}",
                "point-in-triangle {'triangle':[[0,0],[8,0],[0,6]],'points':[[1,1],[9,9]]} {'inside':[true,false]}",
                "triangulate {'polygon':[[0,0],[8,0],[0,6]]} {'triangles':[[0,1,2]]}"
            })
    void whatLiesInThePlaneIsDrawnToScale(String topicInputAndAnswer) throws IOException {
        String[] parts = topicInputAndAnswer.split(" ");
        BufferedImage picture = picture(parts[0], parts[1], parts[2]);
        int dark = 0;
        for (int y = 0; y < picture.getHeight(); y++)
            for (int x = 0; x < picture.getWidth(); x++)
                if ((picture.getRGB(x, y) & 0xFF) < 0x60) dark++;
        assertTrue(dark > 20, dark + " dark dots of an answer");
        assertTrue(picture.getWidth() > 300, picture.getWidth() + " columns");
    }

    @Test
    void numbersStandInATable() throws IOException {
        BufferedImage one = picture("line-plane", "{}", "{'point':[1,2,3]}");
        BufferedImage two = picture("line-plane", "{}", "{'point':[1,2,3],'other':[4,5,6]}");
        assertTrue(two.getHeight() > one.getHeight(), "a row more");
    }
}
