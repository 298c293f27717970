package rasterlab.app.canvas.lab;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Rectangle;
import java.util.HashSet;
import java.util.Set;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.JSlider;
import javax.swing.Scrollable;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The column right of the stage: choosers, live numbers and explanations under headings. */
public final class Inspector extends JPanel implements Scrollable {
    private static final long serialVersionUID = 1L;

    /** The most by which sizes rounded one by one can be larger than their rounded sum. */
    private static final int ROUNDING = 6;

    private final transient Texts texts;
    private final boolean stacked = LargeType.now();
    private final transient Set<Component> lowered = new HashSet<>();
    private final transient FocusInSight focus = new FocusInSight(this);

    public Inspector(Texts texts) {
        super(
                new MigLayout(
                        "insets 0 2 4 0, gap 6 5, wrap 2, hidemode 3", "[pref!]8[grow,fill]", ""));
        this.texts = texts;
    }

    @Override
    public void addNotify() {
        super.addNotify();
        focus.start();
    }

    @Override
    public void removeNotify() {
        focus.stop();
        super.removeNotify();
    }

    Language language() {
        return texts.language();
    }

    public void heading(String key) {
        var label = new JLabel(texts.text(key));
        label.putClientProperty("FlatLaf.styleClass", "h4");
        label.setFont(label.getFont().deriveFont(Font.BOLD));
        label.setName(key);
        if (getComponentCount() > 0) add(new JSeparator(), "span 2, growx, gaptop 6, wmin 0");
        add(label, "span 2, growx, wmin 0");
    }

    /**
     * Adds a control behind its label, whose mnemonic goes to the control. A list of choices is
     * never narrower than its longest one, and in large type stands below its label; other controls
     * give way.
     */
    public void row(String key, JComponent control) {
        var label = new JLabel(texts.label(key));
        label.setName(key);
        label.setLabelFor(control);
        if (texts.mnemonic(key) != 0) {
            label.setDisplayedMnemonic(texts.mnemonic(key));
            label.setDisplayedMnemonicIndex(texts.mnemonicIndex(key));
        }
        add(label, control);
    }

    /** Adds a control behind a label of another part's texts, which has no mnemonic here. */
    public void row(String name, String said, JComponent control) {
        var label = new JLabel(said);
        label.setName(name);
        label.setLabelFor(control);
        add(label, control);
    }

    private void add(JLabel label, JComponent control) {
        boolean list = control instanceof JComboBox;
        add(label, list && stacked ? "span 2" : "");
        add(control, (list ? "wmin pref" : "wmin 0") + (list && stacked ? ", span 2, growx" : ""));
    }

    /** A number that changes while the lab works. */
    public JLabel value(String key) {
        var value = new JLabel(" ");
        row(key, value);
        value.setName(key + ".value");
        return value;
    }

    /** Shows or hides a value with its label. */
    public void showRow(JComponent control, boolean shown) {
        control.setVisible(shown);
        for (Component each : getComponents())
            if (each instanceof JLabel label && label.getLabelFor() == control)
                label.setVisible(shown);
    }

    /** Calls a row by the text of another key than it was made with. */
    public void nameRow(JComponent control, String key) {
        for (Component each : getComponents())
            if (each instanceof JLabel label && label.getLabelFor() == control)
                label.setText(texts.label(key));
    }

    /** Whether the type is so large that lists stand below their labels, to take less width. */
    boolean stacked() {
        return stacked;
    }

    @Override
    public void doLayout() {
        super.doLayout();
        if (stacked && getWidth() >= getMinimumSize().width && lowerWide()) {
            super.doLayout();
            revalidate();
        }
    }

    /**
     * Puts what lacks width below its label, for good: a row that went to and fro with its number
     * would move all others.
     */
    private boolean lowerWide() {
        boolean any = false;
        for (Component each : getComponents())
            if (each instanceof JLabel label
                    && label.getLabelFor() instanceof JComponent control
                    && lacksWidth(control)
                    && lowered.add(control)) {
                var layout = (MigLayout) getLayout();
                layout.setComponentConstraints(label, "span 2");
                layout.setComponentConstraints(control, "span 2, growx, wmin 0");
                any = true;
            }
        return any;
    }

    /** A slider is nearly as good short as long; lists are below their labels already. */
    private static boolean lacksWidth(JComponent control) {
        if (!control.isVisible() || control instanceof JComboBox) return false;
        if (control instanceof JSlider) return tooShort(control);
        for (Component part : control.getComponents())
            if (part instanceof JSlider) return tooShort(part);
        return control.getWidth() < control.getPreferredSize().width;
    }

    private static boolean tooShort(Component slider) {
        return slider.getWidth() < slider.getMinimumSize().width;
    }

    public void wide(JComponent component) {
        add(component, "span 2, growx, wmin 0");
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return 16;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(16, visible.height - 32);
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return getParent().getWidth() >= getMinimumSize().width - ROUNDING;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return false;
    }
}
