package rasterlab.app.canvas.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import javax.swing.JLabel;
import javax.swing.JSlider;
import org.junit.jupiter.api.Test;

class NumberSliderTest {
    @Test
    void sliderEndsAtTheSamePlaceWhateverItsNumber() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    int first = end("0.85");
                    for (String number :
                            new String[] {"0", "0.2", "200", "−1.5", "360°", "0.035 ρ"})
                        assertEquals(first, end(number), number);
                });
    }

    @Test
    void longerNumberStillHasItsRoom() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    NumberSlider slider = shown("−1.25·10⁻⁷ ρ²");
                    var reading = (JLabel) slider.getComponent(1);
                    assertTrue(reading.getWidth() >= reading.getPreferredSize().width);
                });
    }

    private static int end(String number) {
        var slider = (JSlider) shown(number).getComponent(0);
        return slider.getX() + slider.getWidth();
    }

    private static NumberSlider shown(String number) {
        var slider = new NumberSlider("k", "k", 0, 1, false, 100, value -> {});
        slider.show(0.5, number);
        slider.setSize(300, 30);
        slider.doLayout();
        return slider;
    }
}
