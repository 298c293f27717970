package rasterlab.app.exercise.panel;

import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.exercise.HintView;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.language.Texts;

/** The button that shows the next hint and says what it costs, below the statement. */
public final class HintRow extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private final JButton next = new JButton();
    private final JTextArea words = Controls.words("hint.words");

    /**
     * @param take asks for the next hint
     */
    public HintRow(Texts texts, Runnable take) {
        super(new MigLayout("insets 0, gap 8 4, hidemode 3, wrap 1", "[grow,fill]"));
        this.texts = texts;
        setName("hints");
        next.setName("hint");
        next.putClientProperty("FlatLaf.style", "minimumWidth: 0");
        next.addActionListener(e -> take.run());
        words.getAccessibleContext().setAccessibleName(texts.text("hint.words"));
        add(next, "grow 0, wmin 0");
        add(words, "wmin 0");
    }

    public void show(HintView view, boolean asking, Notice notice) {
        setVisible(view.steps() > 0);
        next.setVisible(view.more());
        next.setEnabled(!asking);
        next.setText(button(view));
        words.setText(notice.isEmpty() ? rule(view) : notice.in(texts));
    }

    private String button(HintView view) {
        int step = view.shown().size() + 1;
        return switch (view.origin()) {
            case UNASKED -> texts.text("hint.ask");
            case PRACTICE -> texts.text("hint.practice", step, view.steps());
            case SERVER -> texts.text("hint.next", step, view.steps(), view.cost().orElse(0));
        };
    }

    private String rule(HintView view) {
        return switch (view.origin()) {
            case UNASKED -> texts.text("hint.rule.unasked");
            case PRACTICE -> texts.text("hint.rule.practice");
            case SERVER -> texts.text(view.more() ? "hint.rule.server" : "hint.rule.all");
        };
    }
}
