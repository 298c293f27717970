package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.image.BufferedImage;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.DefaultTableModel;
import org.junit.jupiter.api.Test;

class OffscreenPainterTest {
    @Test
    void tableHasItsColumnNames() throws InterruptedException {
        var table = new JTable(new DefaultTableModel(new String[] {"Verdict"}, 3));
        table.getTableHeader()
                .setDefaultRenderer(
                        (shown, value, selected, focused, row, column) -> {
                            var name = new JLabel(value.toString());
                            name.setOpaque(true);
                            name.setBackground(Color.RED);
                            return name;
                        });
        BufferedImage image = OffscreenPainter.paint(new JScrollPane(table), 100, 100);
        assertEquals(Color.RED.getRGB(), image.getRGB(80, 8));
    }
}
