package rasterlab.app.shell;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JLabel;

/** The product's sign for the window's title and the task bar. */
final class WindowIcon {
    private WindowIcon() {}

    static List<Image> images() {
        return List.of(image(16), image(32), image(48), image(128));
    }

    private static Image image(int size) {
        var icon = new BrandIcon();
        var image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        var g = image.createGraphics();
        g.scale(size / (double) icon.getIconWidth(), size / (double) icon.getIconHeight());
        icon.paintIcon(new JLabel(), g, 0, 0);
        g.dispose();
        return image;
    }
}
