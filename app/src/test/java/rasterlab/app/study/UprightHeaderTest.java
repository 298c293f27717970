package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Font;
import java.util.List;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.shell.settings.LabTheme;

class UprightHeaderTest {
    private static final String[] NAMES = {"dda", "bresenham-pascal-textbook", "clip first"};
    private static final int HEIGHT = 450;

    @AfterEach
    void usualTheme() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    @Test
    void nameIsFoldedNearestToItsMiddle() {
        assertEquals(
                List.of("bresenham-", "pascal-textbook"),
                UprightHeader.lines("bresenham-pascal-textbook", true));
        assertEquals(
                List.of("clip-first-", "textbook"),
                UprightHeader.lines("clip-first-textbook", true));
        assertEquals(List.of("clip", "first"), UprightHeader.lines("clip first", true));
        assertEquals(List.of("dda"), UprightHeader.lines("dda", true));
        assertEquals(List.of("clip first"), UprightHeader.lines("clip first", false));
    }

    @Test
    void namesOfLargeTypeLeaveTheRowsTheirRoomAndStayLarge() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.PROJECTOR.install(200);
                    var table = new JTable(new Object[3][NAMES.length], NAMES);
                    var type = table.getFont().deriveFont(Font.PLAIN, 37f);
                    table.setFont(type);
                    for (int i = 0; i < NAMES.length; i++)
                        table.getColumnModel().getColumn(i).setPreferredWidth(76);
                    var scroll = new JScrollPane(table);
                    scroll.setSize(900, HEIGHT);
                    Component head =
                            new UprightHeader(false)
                                    .getTableCellRendererComponent(
                                            table, NAMES[1], false, false, -1, 1);
                    assertTrue(head.getPreferredSize().height <= 0.65 * HEIGHT, head.toString());
                    assertTrue(head.getFont().getSize2D() >= 0.7 * 37, head.getFont().toString());
                });
    }
}
