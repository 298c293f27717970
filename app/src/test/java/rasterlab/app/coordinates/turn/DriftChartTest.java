package rasterlab.app.coordinates.turn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.UIManager;
import javax.swing.plaf.FontUIResource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.UsualLook;

class DriftChartTest {
    @BeforeEach
    void largeType() {
        UIManager.put("Label.font", new FontUIResource("SansSerif", 0, 20));
    }

    @AfterEach
    void usualType() throws Exception {
        EventQueue.invokeAndWait(UsualLook::install);
    }

    @ParameterizedTest(name = "words in large type leave the curves no room: {0}")
    @EnumSource(Language.class)
    void curvesHaveAThirdOfTheSmallestChart(Language language) {
        BufferedImage image = painted(language, 380, 270);
        Color curve = MethodColors.edgeOn(StageColors.now().ground(), FigureColors.OWN.of("float"));
        int left = image.getWidth();
        int right = 0;
        for (int y = 0; y < image.getHeight(); y++)
            for (int x = 0; x < image.getWidth(); x++)
                if (image.getRGB(x, y) == curve.getRGB()) {
                    left = Math.min(left, x);
                    right = Math.max(right, x);
                }
        assertTrue(right - left >= 380 / 3, left + " to " + right);
    }

    @Test
    void pointWithoutErrorHasItsLevel() {
        DriftChart chart = chart(Language.ENGLISH, 440, 600);
        String svg = SvgPicture.of(440, 600, chart::draw).document();
        assertTrue(svg.contains(">0</text"), svg);
    }

    private static BufferedImage painted(Language language, int width, int height) {
        DriftChart chart = chart(language, width, height);
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        chart.draw(image.createGraphics());
        return image;
    }

    private static DriftChart chart(Language language, int width, int height) {
        var failures = new CopyOnWriteArrayList<Throwable>();
        var thread = new ModelThread();
        var chart = new DriftChart(Texts.of("coordinates.turn", language));
        try (var model = new TurnLabModel(thread, failures::add)) {
            model.begin();
            thread.settle(model::settle);
            chart.show(model.scene(), false);
        }
        assertEquals(List.of(), failures);
        chart.setSize(width, height);
        return chart;
    }
}
