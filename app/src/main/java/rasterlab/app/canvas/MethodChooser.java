package rasterlab.app.canvas;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JList;

/** A drop-down list of method names, each beside its colour. */
public final class MethodChooser extends JComboBox<String> {
    private static final long serialVersionUID = 1L;

    private boolean refreshing;

    /**
     * @param name the component's name
     * @param none what stands for "no method", first in the list; empty when one must be chosen
     * @param chosen told the method's name, or "" for none, when the user chooses
     */
    public MethodChooser(String name, String none, List<String> methods, Consumer<String> chosen) {
        setName(name);
        if (!none.isEmpty()) addItem("");
        methods.forEach(this::addItem);
        setRenderer(new Renderer(none));
        setMaximumRowCount(20);
        addActionListener(
                e -> {
                    if (!refreshing) chosen.accept((String) getSelectedItem());
                });
    }

    /** Shows a choice without telling anybody. */
    public void show(String method) {
        refreshing = true;
        setSelectedItem(method);
        refreshing = false;
    }

    private static final class Renderer extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        private final String none;

        Renderer(String none) {
            this.none = none;
        }

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            super.getListCellRendererComponent(list, value, index, selected, focused);
            String method = value == null ? "" : value.toString();
            if (method.isEmpty()) setText(none);
            else setIcon(new Swatch(method));
            return this;
        }
    }

    /** A square of the method's colour, with an edge that is seen on any background. */
    private record Swatch(String method) implements Icon {
        @Override
        public void paintIcon(Component c, Graphics g, int x, int y) {
            var copy = (Graphics2D) g.create();
            copy.setRenderingHint(
                    RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            Color colour = MethodColours.of(method);
            copy.setColor(colour);
            copy.fillRoundRect(x, y, getIconWidth(), getIconHeight(), 4, 4);
            copy.setColor(MethodColours.edgeOn(c.getBackground(), colour));
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
}
