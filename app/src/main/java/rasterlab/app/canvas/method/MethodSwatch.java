package rasterlab.app.canvas.method;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.Icon;

/** A square of the method's colour, with an edge that is seen on any background. */
public record MethodSwatch(String method, TopicColors colors) implements Icon {
    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
        var copy = (Graphics2D) g.create();
        copy.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Color color = colors.of(method);
        copy.setColor(color);
        copy.fillRoundRect(x, y, getIconWidth(), getIconHeight(), 4, 4);
        copy.setColor(MethodColors.edgeOn(c.getBackground(), color));
        copy.drawRoundRect(x, y, getIconWidth() - 1, getIconHeight() - 1, 4, 4);
        copy.dispose();
    }

    @Override
    public int getIconWidth() {
        return UIScale.scale(12);
    }

    @Override
    public int getIconHeight() {
        return UIScale.scale(12);
    }
}
