package rasterlab.app.canvas.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.util.List;
import org.junit.jupiter.api.Test;

class NameChooserTest {
    @Test
    void nameThatComesForAWhileDoesNotWidenTheList() throws Exception {
        var always = List.of("vase", "cyclic-overlap");
        EventQueue.invokeAndWait(
                () -> {
                    var list = new NameChooser("scene", always, name -> name, name -> {});
                    list.showListed("vase", always);
                    int usual = list.getMinimumSize().width;
                    String longName = "a scene with a name that is longer than all that are listed";
                    list.showListed(longName, always);
                    assertEquals(usual, list.getMinimumSize().width);
                    assertEquals(longName, list.getToolTipText());
                    list.showListed("vase", always);
                    assertEquals(null, list.getToolTipText());
                });
    }
}
