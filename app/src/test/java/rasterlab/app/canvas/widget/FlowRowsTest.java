package rasterlab.app.canvas.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.stream.Stream;
import javax.swing.JPanel;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class FlowRowsTest {
    @Test
    @DisplayName("words stand at the upper edge of the buttons beside them")
    void aRowHasOneMiddle() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var rows = new JPanel(FlowRows.inTheMiddle(10));
                    rows.setBorder(null);
                    Stream.of(17, 29, 9, 21).forEach(height -> rows.add(part(height)));
                    rows.setSize(330, 100);
                    rows.doLayout();
                    assertEquals(14, middle(rows.getComponent(0)));
                    assertEquals(14, middle(rows.getComponent(1)));
                    assertEquals(14, middle(rows.getComponent(2)));
                    assertEquals(39 + 10, middle(rows.getComponent(3)));
                    assertEquals(29 + 10 + 21, rows.getPreferredSize().height);
                });
    }

    private static JPanel part(int height) {
        var part = new JPanel();
        part.setPreferredSize(new Dimension(100, height));
        return part;
    }

    private static int middle(Component part) {
        return part.getY() + part.getHeight() / 2;
    }
}
