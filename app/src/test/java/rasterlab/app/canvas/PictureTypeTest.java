package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.EventQueue;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.shell.settings.LabTheme;

class PictureTypeTest {
    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @ParameterizedTest(name = "words of {0} % hide a picture of {1}×{2}, or are cut to nothing")
    @CsvSource({"100, 400, 300", "150, 600, 480", "200, 1230, 410", "200, 150, 100"})
    void wordsLeaveThePictureInSight(int percent, int width, int height) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.PROJECTOR.install(percent);
                    float label = UIManager.getFont("Label.font").getSize2D();
                    float type = PictureType.in(new Dimension(width, height)).getSize2D();
                    assertTrue(type <= label, type + " beside labels of " + label);
                    assertTrue(
                            type <= Math.max(14, height / 15f), type + " in a height of " + height);
                    assertTrue(type >= Math.min(14, label), type + " cannot be read");
                });
    }

    @ParameterizedTest(name = "words in a large picture are smaller than labels: {0} %")
    @CsvSource({"100", "150", "200"})
    void largePicturesHaveTheTypeOfLabels(int percent) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.PROJECTOR.install(percent);
                    assertEquals(
                            UIManager.getFont("Label.font").getSize2D(),
                            PictureType.in(new Dimension(1800, 900)).getSize2D());
                });
    }
}
