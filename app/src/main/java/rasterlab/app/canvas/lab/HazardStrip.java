package rasterlab.app.canvas.lab;

import java.awt.Component;
import java.awt.Dimension;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodSwatch;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Verdict;

/**
 * Says over the stage of a clicked hazard what is special about it, what the chosen method's
 * verdict is, and which methods fail: each is a button that chooses it. Where no method is judged
 * it says why.
 *
 * <p>It stays until it is closed or another mode is shown, so that the stage keeps its size while
 * the input is changed; then it tells that the verdicts are of the case as it was.
 */
final class HazardStrip extends JPanel {
    private static final long serialVersionUID = 1L;

    /** View units that the layout leaves on both sides of the row together. */
    private static final int BESIDE = 16;

    private final transient Texts texts;
    private final transient Texts verdicts;
    private final WrappedText special = new WrappedText("hazard.special");
    private final WrappedText unjudged = new WrappedText("hazard.unjudged");
    private final JPanel row = new JPanel(FlowRows.inTheMiddle(6));
    private final JLabel verdict = new JLabel();
    private transient Optional<HazardCase> shown = Optional.empty();
    private transient Optional<LabInput> lab = Optional.empty();
    private transient Object input = "";
    private transient String before = "";
    private transient Component source = this;
    private int tallest;
    private boolean judging;

    HazardStrip(Texts texts) {
        super(new MigLayout("insets 6 10 6 6, gap 4 4, hidemode 3", "[grow,fill][]"));
        this.texts = texts;
        verdicts = Texts.of("study", texts.language());
        setName("hazard.strip");
        row.setOpaque(false);
        FlowRows.keepWrapped(row);
        verdict.setName("hazard.verdict");
        verdict.setBorder(BorderFactory.createEmptyBorder(0, 0, 0, 14));
        add(special, "wmin 0, aligny center");
        add(close(), "aligny top, wrap");
        add(unjudged, "wmin 0, span 2, wrap");
        add(row, "wmin 0, span 2");
        setVisible(false);
    }

    private JButton close() {
        var close = new JButton("×");
        close.setName("hazard.close");
        close.setToolTipText(texts.text("hazard.close"));
        close.getAccessibleContext().setAccessibleName(texts.text("hazard.close"));
        close.putClientProperty("JButton.buttonType", "toolBarButton");
        close.putClientProperty("JButton.squareSize", true);
        close.addActionListener(e -> close(this));
        return close;
    }

    private static void close(HazardStrip strip) {
        strip.shown = Optional.empty();
        strip.refresh();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        StageColors colors = StageColors.now();
        setBackground(colors.margin());
        setBorder(
                BorderFactory.createMatteBorder(
                        1, 1, 1, 1, UIManager.getColor("Component.borderColor")));
    }

    /** Says with whose input and method the verdicts are compared. */
    void of(LabInput next) {
        lab = Optional.of(next);
    }

    /**
     * Says all about a hazard whose input is shown now.
     *
     * @param chips among which it was chosen: the strip goes when they are hidden
     */
    void tell(HazardCase hazard, Component chips) {
        Object now = lab.<Object>map(one -> one.input().get()).orElse("");
        tellAgain(new ShownHazard(hazard, now, method(), false), chips);
    }

    /** Goes on telling what was told over the same stage before it was made again. */
    void tellAgain(ShownHazard told, Component chips) {
        if (source instanceof Chips others && others != chips) others.mark("");
        shown = Optional.of(told.hazard());
        source = chips;
        input = told.input();
        before = told.before();
        tallest = 0;
        judging = false;
        refresh();
    }

    /** The hazard that is told now, if one is. */
    Optional<ShownHazard> shownHazard() {
        return shown.map(hazard -> new ShownHazard(hazard, input, before, judging && !changed()));
    }

    private boolean changed() {
        return lab.isPresent() && !lab.get().input().get().equals(input);
    }

    /** Adds verdicts to the hazard of that name, if it is still told. */
    void judge(String name, Map<String, Verdict.Kind> found) {
        judging = false;
        shown = shown.map(each -> each.name().equals(name) ? each.judged(found) : each);
        refresh();
    }

    /** Says that verdicts are being found. */
    void judging() {
        judging = true;
        refresh();
    }

    private String method() {
        return lab.map(one -> one.method().get()).orElse("");
    }

    /** Compares what was told with the lab's present state. */
    void refresh() {
        if (shown.isPresent() && !source.isVisible()) shown = Optional.empty();
        setVisible(shown.isPresent());
        if (source instanceof Chips chips) chips.mark(shown.map(HazardCase::name).orElse(""));
        if (shown.isEmpty()) return;
        HazardCase hazard = shown.get();
        boolean changed = changed();
        special.show(texts.text("hazard.special", hazard.label(), hazard.special()));
        special.setEnabled(!changed);
        row.removeAll();
        if (changed) addChanged(hazard);
        else if (!hazard.methods().isEmpty()) addVerdicts(hazard);
        else if (judging) row.add(new JLabel(texts.text("hazard.judging")));
        row.setVisible(row.getComponentCount() > 0);
        unjudged.show(lab.map(LabInput::unjudged).orElse(""));
        unjudged.setVisible(
                !changed
                        && !judging
                        && hazard.methods().isEmpty()
                        && !unjudged.getText().isEmpty());
        row.revalidate();
        row.repaint();
    }

    private void addChanged(HazardCase hazard) {
        var said = new JLabel(texts.text("hazard.changed"));
        said.setName("hazard.changed");
        row.add(said);
        row.add(button("hazard.again", texts.text("hazard.again"), () -> again(hazard)));
    }

    private void again(HazardCase hazard) {
        hazard.show().run();
        tell(hazard, source);
    }

    private void addVerdicts(HazardCase hazard) {
        String method = method();
        Verdict.Kind kind = hazard.recorded().get(method);
        if (kind != null) {
            verdict.setText(verdictText(method, kind));
            verdict.setIcon(swatch(method));
            row.add(verdict);
        }
        List<String> others =
                hazard.failing().stream().filter(each -> !each.equals(method)).toList();
        if (hazard.failing().isEmpty()) row.add(new JLabel(texts.text("hazard.all")));
        if (!others.isEmpty()) row.add(new JLabel(texts.text("hazard.failing")));
        for (String failing : others) row.add(choice(failing, hazard));
        boolean back = !before.equals(method) && !hazard.failing().contains(before);
        if (!back || !hazard.recorded().containsKey(before)) return;
        var words = new JLabel(texts.text("hazard.back"));
        words.setName("hazard.back");
        row.add(words);
        row.add(choice(before, hazard));
    }

    private JButton choice(String method, HazardCase hazard) {
        String text = verdictText(method, hazard.recorded().get(method));
        JButton button =
                button(
                        "hazard.method." + method,
                        text,
                        () -> {
                            lab.ifPresent(one -> one.choose().accept(method));
                            refresh();
                        });
        button.setIcon(swatch(method));
        button.setToolTipText(texts.text("hazard.choose", called(method)));
        return button;
    }

    private String verdictText(String method, Verdict.Kind kind) {
        String found = verdicts.text("verdict." + kind.code());
        return texts.text("hazard.verdict", called(method), found);
    }

    private String called(String method) {
        return lab.map(one -> one.called().apply(method)).orElse(method);
    }

    /** The method's colour; null where it shares one with others, which would tell nothing. */
    private Icon swatch(String method) {
        return lab.map(LabInput::colors)
                .filter(colors -> colors.has(method))
                .map(colors -> new MethodSwatch(method, colors))
                .orElse(null);
    }

    private static JButton button(String name, String text, Runnable action) {
        JButton button = Chips.chip(name, text, action);
        button.setFocusable(false);
        return button;
    }

    /** No smaller than before for the same hazard, so that the stage keeps its size. */
    @Override
    public Dimension getPreferredSize() {
        // A row that was hidden still has the width of another time, by which it would be wrapped.
        int wide = getWidth() - getInsets().left - getInsets().right - BESIDE;
        if (wide > 0 && row.getWidth() != wide) row.setSize(wide, row.getHeight());
        Dimension size = super.getPreferredSize();
        tallest = Math.max(tallest, size.height);
        return new Dimension(size.width, tallest);
    }
}
