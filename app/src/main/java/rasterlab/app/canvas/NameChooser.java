package rasterlab.app.canvas;

import java.awt.Component;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;

/** A drop-down list of names, each shown with what it says in the window's language. */
public final class NameChooser extends JComboBox<String> {
    private static final long serialVersionUID = 1L;

    private boolean refreshing;

    /**
     * @param name the component's name
     * @param said what the list shows for a name
     * @param chosen told the name that the user chooses
     */
    public NameChooser(
            String name, List<String> names, UnaryOperator<String> said, Consumer<String> chosen) {
        setName(name);
        names.forEach(this::addItem);
        setRenderer(
                new DefaultListCellRenderer() {
                    private static final long serialVersionUID = 1L;

                    @Override
                    public Component getListCellRendererComponent(
                            JList<?> list, Object item, int index, boolean on, boolean focused) {
                        String shown = item == null ? "" : said.apply(item.toString());
                        return super.getListCellRendererComponent(list, shown, index, on, focused);
                    }
                });
        addActionListener(
                e -> {
                    if (!refreshing) chosen.accept((String) getSelectedItem());
                });
    }

    /** Shows a choice that is in the list for as long as it is shown, unless it is always there. */
    public void showListed(String chosen, List<String> always) {
        refreshing = true;
        if (getPrototypeDisplayValue() == null) setPrototypeDisplayValue(longest(always));
        for (int i = getItemCount() - 1; i >= 0; i--)
            if (!always.contains(getItemAt(i)) && !getItemAt(i).equals(chosen)) removeItemAt(i);
        if (!always.contains(chosen) && getItemCount() == always.size()) addItem(chosen);
        setSelectedItem(chosen);
        setToolTipText(always.contains(chosen) ? null : chosen);
        refreshing = false;
    }

    /** A longer name that comes for a while is shortened, and does not widen the list. */
    private static String longest(List<String> names) {
        return Collections.max(names, Comparator.comparingInt(String::length));
    }

    /** Shows a choice without telling anybody. */
    public void show(String chosen) {
        refreshing = true;
        setSelectedItem(chosen);
        refreshing = false;
    }
}
