package rasterlab.app.canvas.widget;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JList;

/**
 * A drop-down list of names, each shown with what it says in the window's language. After a choice
 * by keys it keeps the keyboard, so that the next key changes the list again and no figure; where
 * another lab of the tab came, that lab's list of the same name has it.
 */
public final class NameChooser extends JComboBox<String> {
    private static final long serialVersionUID = 1L;

    private boolean refreshing;

    /** Whether a choice by keys is being told. */
    private boolean keyed;

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
                    if (!refreshing) choose(chosen);
                });
    }

    private void choose(Consumer<String> chosen) {
        // This asks first, because showing the answer makes events as well.
        keyed = EventQueue.getCurrentEvent() instanceof KeyEvent;
        chosen.accept((String) getSelectedItem());
        if (keyed) keepKeyboard();
        keyed = false;
    }

    /** Whether the choice that is told now was made by keys. */
    public static boolean byKeys() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()
                        instanceof NameChooser list
                && list.keyed;
    }

    /** Asks twice, since Swing moves the focus out of what was hidden by itself, at times later. */
    private void keepKeyboard() {
        Container seen = this;
        while (seen != null && !seen.isShowing()) seen = seen.getParent();
        if (seen == null) return;
        same(seen)
                .ifPresent(
                        list -> {
                            list.requestFocusInWindow();
                            EventQueue.invokeLater(list::requestFocusInWindow);
                        });
    }

    private Optional<NameChooser> same(Component root) {
        if (root instanceof NameChooser list && getName().equals(list.getName()))
            return Optional.of(list);
        if (!(root instanceof Container inner)) return Optional.empty();
        return Arrays.stream(inner.getComponents())
                .filter(Component::isVisible)
                .map(this::same)
                .flatMap(Optional::stream)
                .findFirst();
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

    /** Offers those names from now on, and shows a choice of them without telling anybody. */
    public void offer(List<String> names, String chosen) {
        refreshing = true;
        if (!IntStream.range(0, getItemCount()).mapToObj(this::getItemAt).toList().equals(names)) {
            removeAllItems();
            names.forEach(this::addItem);
        }
        setSelectedItem(chosen);
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
