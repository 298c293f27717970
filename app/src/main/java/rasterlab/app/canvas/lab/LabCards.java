package rasterlab.app.canvas.lab;

import java.awt.CardLayout;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

/**
 * The labs of one tab, of which one is seen; each is made when it is first seen.
 *
 * @param <K> what tells the labs apart
 */
public final class LabCards<K> implements AutoCloseable {
    private final LabPanel tab;
    private final Function<K, LabPanel> made;
    private final CardLayout layout = new CardLayout();
    private final Map<K, LabPanel> labs = new LinkedHashMap<>();
    private final Set<K> unseen = new HashSet<>();

    /**
     * @param tab shows the labs and nothing else
     */
    public LabCards(LabPanel tab, Function<K, LabPanel> made) {
        this.tab = tab;
        this.made = made;
        tab.setLayout(layout);
    }

    /** Shows that lab, and stops what the others play. */
    public void show(K key) {
        labs.values().forEach(LabPanel::stop);
        if (!labs.containsKey(key)) begin(key).forEach(Runnable::run);
        if (unseen.remove(key)) labs.get(key).refresh();
        layout.show(tab, key.toString());
        tab.revalidate();
    }

    /**
     * Makes a lab that is not there.
     *
     * @return what is still to be made of it before it is shown, as {@link LabPanel#parts}
     */
    public List<Runnable> begin(K key) {
        LabPanel lab = made.apply(key);
        tab.add(lab, key.toString());
        labs.put(key, lab);
        unseen.add(key);
        return lab.parts();
    }

    /** Gives the keyboard to the picture of a lab that has been shown. */
    public void focusPicture(K key) {
        labs.get(key).focusPicture();
    }

    /** Closes the labs that were made. */
    @Override
    public void close() {
        labs.values().forEach(LabPanel::close);
    }
}
