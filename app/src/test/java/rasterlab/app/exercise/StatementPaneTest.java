package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;

import javax.swing.text.AttributeSet;
import javax.swing.text.html.CSS;
import javax.swing.text.html.HTMLEditorKit;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.shell.LabTheme;

class StatementPaneTest {
    @Test
    @DisplayName("tables of other tabs get the statement's borders")
    void styleIsItsOwn() {
        LabTheme.LIGHT.install();
        var pane = new StatementPane("Statement");
        assertEquals("solid", border((HTMLEditorKit) pane.getEditorKit()));
        assertEquals("inset", border(new HTMLEditorKit()));
    }

    private static String border(HTMLEditorKit kit) {
        AttributeSet cell = kit.getStyleSheet().getRule("td");
        return cell.getAttribute(CSS.Attribute.BORDER_TOP_STYLE).toString();
    }
}
