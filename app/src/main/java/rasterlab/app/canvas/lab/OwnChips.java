package rasterlab.app.canvas.lab;

import java.awt.Container;
import java.awt.event.HierarchyEvent;
import java.awt.event.HierarchyListener;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.KeyBinding;

/**
 * Adds the cases of the user's that a lab is offered to the chips of their topic, before the others
 * so that none is left out; each can be removed by its menu or by the Delete key.
 */
public final class OwnChips implements HierarchyListener {
    private static final String OFFERED = "Rasterlab.ownCases";

    private final Chips chips;
    private final String topic;
    private boolean added;

    private OwnChips(Chips chips, String topic) {
        this.chips = chips;
        this.topic = topic;
    }

    /** Finds the cases of a topic. */
    @FunctionalInterface
    public interface CaseFinder {
        List<OwnCase> of(String topic);
    }

    /** Offers cases to all chips in a lab, also to those that are made later. */
    public static void offer(JComponent lab, CaseFinder cases) {
        lab.putClientProperty(OFFERED, cases);
    }

    /** Adds the cases of that topic as soon as the chips are in a lab that is offered some. */
    static void into(Chips chips, String topic) {
        chips.addHierarchyListener(new OwnChips(chips, topic));
    }

    @Override
    public void hierarchyChanged(HierarchyEvent e) {
        if (added || (e.getChangeFlags() & HierarchyEvent.PARENT_CHANGED) == 0) return;
        for (Container each = chips.getParent(); each != null; each = each.getParent())
            if (each instanceof JComponent lab
                    && lab.getClientProperty(OFFERED) instanceof CaseFinder offer) {
                added = true;
                List<OwnCase> cases = offer.of(topic);
                for (int i = 0; i < cases.size(); i++) add(cases.get(i), i);
                return;
            }
    }

    private void add(OwnCase one, int at) {
        JButton chip = chips.add(one.hazard(), at);
        Runnable removing =
                () -> {
                    one.removing().run();
                    chips.drop(one.hazard(), chip);
                };
        var menu = new JPopupMenu();
        menu.setLightWeightPopupEnabled(false);
        var item = new JMenuItem(one.removal());
        item.setName(chip.getName() + ".remove");
        item.addActionListener(e -> removing.run());
        menu.add(item);
        chip.setComponentPopupMenu(menu);
        KeyBinding.whenFocused(chip, KeyStroke.getKeyStroke("DELETE"), removing);
    }
}
