package rasterlab.app.exercise.statement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.StatementPicture;
import rasterlab.exercises.catalogue.Catalogue;

class PicturePlateTest {
    private static final int RED = Color.RED.getRGB();

    private static BufferedImage plate(StatementPicture picture) {
        return (BufferedImage) PicturePlate.of(picture, "en").orElseThrow();
    }

    private static StatementPicture svg(String text) {
        return StatementPicture.of("a.svg", text.getBytes(StandardCharsets.UTF_8));
    }

    private static byte[] png(int width, int height) throws IOException {
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        int[] red = new int[width * height];
        Arrays.fill(red, RED);
        image.setRGB(0, 0, width, height, red, 0, width);
        var bytes = new ByteArrayOutputStream();
        ImageIO.write(image, "png", bytes);
        return bytes.toByteArray();
    }

    @Test
    void drawingFillsItsPlate() {
        BufferedImage plate =
                plate(
                        svg(
                                "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='20'>"
                                        + "<rect width='40' height='20' fill='#f00'/></svg>"));
        assertEquals(Color.WHITE.getRGB(), plate.getRGB(0, 0));
        assertEquals(RED, plate.getRGB(plate.getWidth() / 2, plate.getHeight() / 2));
        assertEquals(20, plate.getWidth() - plate.getHeight());
    }

    @Test
    void pictureIsMadeSmallerWhereItIsTooWide() throws IOException {
        BufferedImage small = plate(StatementPicture.of("a.png", png(30, 10)));
        BufferedImage wide = plate(StatementPicture.of("a.png", png(3000, 1000)));
        assertEquals(RED, wide.getRGB(wide.getWidth() / 2, wide.getHeight() / 2));
        assertTrue(wide.getWidth() < 1000, wide.getWidth() + " pixels");
        assertTrue(small.getWidth() < wide.getWidth());
    }

    @Test
    void brokenFilesAreNoPictures() throws IOException {
        byte[] cut = Arrays.copyOf(png(30, 10), 20);
        assertEquals(Optional.empty(), PicturePlate.of(StatementPicture.of("a.png", cut), "en"));
        assertEquals(Optional.empty(), PicturePlate.of(svg("<svg"), "en"));
        assertEquals(
                Optional.empty(),
                PicturePlate.of(
                        svg(
                                "<svg xmlns='http://www.w3.org/2000/svg' width='90000' height='90000'/>"),
                        "en"));
    }

    @Test
    void everyPictureOfTheCatalogueIsDrawn() {
        for (Exercise exercise : Catalogue.builtIn().all())
            exercise.pictures()
                    .forEach(
                            (name, picture) -> {
                                BufferedImage plate = plate(picture);
                                int[] all =
                                        plate.getRGB(
                                                0,
                                                0,
                                                plate.getWidth(),
                                                plate.getHeight(),
                                                null,
                                                0,
                                                plate.getWidth());
                                assertTrue(Arrays.stream(all).distinct().count() > 3, name);
                            });
    }
}
