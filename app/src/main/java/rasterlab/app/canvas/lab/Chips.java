package rasterlab.app.canvas.lab;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.language.Texts;

/**
 * The topic's hazards above the stage: one click brings the input on which methods fail. Those that
 * would take too much of the stage's height are in a menu at the end.
 */
public final class Chips extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final int GAP = 6;

    /** No count of hazards is written wider. */
    private static final int WIDEST = 88;

    private final transient Texts texts;
    private final transient List<HazardCase> cases = new ArrayList<>();
    private final JButton more = chip("chips.more", "", this::openMenu);

    /**
     * @param key in texts, of the title before the chips
     */
    public Chips(Texts texts, String key) {
        super(null);
        this.texts = Texts.of("canvas", texts.language());
        Dimension size =
                chip("", this.texts.text("chips.more", WIDEST), () -> {}).getPreferredSize();
        setLayout(new ChipRows(GAP, more, size, this::leaveOut));
        setOpaque(false);
        var label = new JLabel(texts.text(key));
        label.setName("chips.title");
        add(label);
        add(more);
        FlowRows.keepWrapped(this);
    }

    /**
     * @param name the hazard's name as on the command line
     * @param text what the chip says
     * @param hint one sentence: what is special about the input
     */
    public void add(String name, String text, String hint, Runnable action) {
        add(HazardCase.unjudged(name, text, hint, action));
    }

    /** Adds a chip that also says over the stage what is special, and which methods fail. */
    public void add(HazardCase hazard) {
        add(hazard, cases.size());
    }

    /** Names the topic whose hazards these are: cases of the user's come before them. */
    public Chips of(String topic) {
        OwnChips.into(this, topic);
        return this;
    }

    /**
     * @param at number of chips before it
     */
    JButton add(HazardCase hazard, int at) {
        JButton chip = chip("chip." + hazard.name(), hazard.label(), () -> choose(hazard));
        chip.setToolTipText(hazard.special());
        chip.getAccessibleContext().setAccessibleDescription(hazard.special());
        add(chip, at + 1);
        cases.add(at, hazard);
        return chip;
    }

    /** Takes a chip away; what is told over the stage stays. */
    void drop(HazardCase hazard, JButton chip) {
        cases.remove(hazard);
        remove(chip);
        revalidate();
        repaint();
    }

    private void choose(HazardCase hazard) {
        hazard.show().run();
        tell(hazard);
    }

    /**
     * Says all about a hazard that was shown by other means than its chip.
     *
     * @param place whose visible chips have it, if any have
     */
    public static void tell(String name, Container place) {
        for (Component child : place.getComponents())
            if (child.isVisible() && child instanceof Chips chips) chips.tell(name);
            else if (child.isVisible() && child instanceof Container inner) tell(name, inner);
    }

    private void tell(String name) {
        cases.stream().filter(each -> each.name().equals(name)).forEach(this::tell);
    }

    private void tell(HazardCase hazard) {
        if (SwingUtilities.getAncestorOfClass(LabLayout.class, this) instanceof LabLayout lab)
            lab.guide().clicked(hazard, this);
    }

    /** The hazard that is told over the stage of the lab that is seen there. */
    public static Optional<ShownHazard> shownHazardIn(Container place) {
        return Stream.of(place.getComponents())
                .filter(Component::isVisible)
                .flatMap(
                        child ->
                                child instanceof LabLayout lab
                                        ? lab.guide().shownHazard().stream()
                                        : child instanceof Container inner
                                                ? shownHazardIn(inner).stream()
                                                : Stream.empty())
                .findFirst();
    }

    /** Tells it again over the same lab, made again, in the language of its chips. */
    public static void tellAgain(ShownHazard told, Container place) {
        for (Component child : place.getComponents())
            if (child.isVisible() && child instanceof Chips chips) chips.tellAgain(told);
            else if (child.isVisible() && child instanceof Container inner) tellAgain(told, inner);
    }

    /** A hazard whose verdicts were not found yet is shown again, which looks for them. */
    private void tellAgain(ShownHazard told) {
        for (HazardCase each : List.copyOf(cases)) {
            if (!each.name().equals(told.hazard().name())) continue;
            if (told.judging()) choose(each);
            else if (SwingUtilities.getAncestorOfClass(LabLayout.class, this)
                    instanceof LabLayout lab) lab.guide().tellAgain(told, each, this);
        }
    }

    /**
     * Marks the chip of the hazard that is told over the stage, wherever the keyboard is.
     *
     * @param name "" for none
     */
    void mark(String name) {
        for (Component each : getComponents())
            if (each instanceof JButton chip && chip != more)
                chip.setSelected(chip.getName().equals("chip." + name));
        markMore();
    }

    /** The chip that is marked may be in the menu. */
    private void markMore() {
        more.setSelected(
                Stream.of(getComponents())
                        .anyMatch(
                                each ->
                                        each instanceof JButton chip
                                                && chip != more
                                                && chip.isSelected()
                                                && !chip.isVisible()));
    }

    static JButton chip(String name, String text, Runnable action) {
        var chip = new JButton(text);
        chip.setName(name);
        chip.putClientProperty("JButton.buttonType", "roundRect");
        chip.putClientProperty("FlatLaf.styleClass", "medium");
        chip.putClientProperty("FlatLaf.style", "margin: 2,4,2,4; minimumWidth: 0");
        chip.addActionListener(e -> action.run());
        return chip;
    }

    private void leaveOut(int count) {
        String text = texts.text("chips.more", count);
        if (!text.equals(more.getText())) more.setText(text);
    }

    private void openMenu() {
        menu().show(more, 0, more.getHeight());
    }

    /**
     * The menu of those chips for which there was no room; a light menu would be hidden by a window
     * of OpenGL.
     */
    JPopupMenu menu() {
        var menu = new JPopupMenu();
        menu.setName("chips.menu");
        menu.setLightWeightPopupEnabled(false);
        for (Component each : getComponents())
            if (each instanceof JButton chip && !chip.isVisible()) menu.add(item(chip));
        return menu;
    }

    private static JMenuItem item(JButton chip) {
        var item = new JMenuItem(chip.getText());
        item.setName(chip.getName() + ".item");
        item.setToolTipText(chip.getToolTipText());
        item.addActionListener(e -> chip.doClick(0));
        return item;
    }

    /** The title lies in the middle of the first row of chips. */
    @Override
    public void doLayout() {
        super.doLayout();
        markMore();
        if (getComponentCount() > 2) {
            Component title = getComponent(0);
            title.setSize(title.getWidth(), getComponent(1).getHeight());
        }
    }
}
