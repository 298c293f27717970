package rasterlab.app.canvas.method;

import java.awt.Component;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;

/** A drop-down list of method names, each beside its colour. */
public final class MethodChooser extends JComboBox<String> {
    private static final long serialVersionUID = 1L;

    private boolean refreshing;

    /** The name of the user's own program. */
    private String called = "";

    /**
     * @param name the component's name
     * @param none what stands for "no method", first in the list; empty when one must be chosen
     * @param colors of the methods
     * @param chosen told the method's name, or "" for none, when the user chooses
     */
    public MethodChooser(
            String name,
            String none,
            List<String> methods,
            TopicColors colors,
            Consumer<String> chosen) {
        setName(name);
        if (!none.isEmpty()) addItem("");
        methods.forEach(this::addItem);
        setRenderer(new Renderer(none, colors));
        setMaximumRowCount(20);
        addActionListener(
                e -> {
                    if (!refreshing) chosen.accept((String) getSelectedItem());
                });
    }

    /** Has the user's own program behind the methods. */
    public MethodChooser withOwn(Texts texts) {
        called = texts.text("method.mine");
        addItem(OwnMethods.NAME);
        return this;
    }

    /** Shows a choice without telling anybody. */
    public void show(String method) {
        refreshing = true;
        setSelectedItem(method);
        refreshing = false;
    }

    private final class Renderer extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        private final String none;
        private final transient TopicColors colors;

        Renderer(String none, TopicColors colors) {
            this.none = none;
            this.colors = colors;
        }

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            super.getListCellRendererComponent(list, value, index, selected, focused);
            String method = value == null ? "" : value.toString();
            if (method.equals(OwnMethods.NAME)) setText(called);
            if (method.isEmpty()) setText(none);
            else setIcon(new MethodSwatch(method, colors));
            return this;
        }
    }
}
