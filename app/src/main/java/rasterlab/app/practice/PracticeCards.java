package rasterlab.app.practice;

import java.awt.CardLayout;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StepQuestions;
import rasterlab.app.language.Language;

/** A lab, or in its place the mode "which is next?", which is made when it is first entered. */
public final class PracticeCards extends LabPanel implements StepQuestions {
    private static final long serialVersionUID = 1L;

    /** Key of the help on the mode. */
    public static final String HELP = "practice";

    private static final String LAB = "lab";
    private static final String MODE = "mode";

    private final CardLayout cards = new CardLayout();
    private final LabPanel lab;
    private final transient PracticeModel model;
    private final transient Language language;
    private transient Optional<PracticePanel> mode = Optional.empty();
    private transient Runnable unsubscribe;

    public PracticeCards(LabPanel lab, PracticeModel model, Language language) {
        this.lab = lab;
        this.model = model;
        this.language = language;
        setLayout(cards);
        add(lab, LAB);
        unsubscribe = model.listen(this::follow);
    }

    @Override
    public List<Runnable> parts() {
        return lab.parts();
    }

    @Override
    public void refresh() {
        lab.refresh();
        if (model.state().topic().isPresent()) showMode();
    }

    @Override
    public void ask(String topic) {
        lab.stop();
        model.enter(topic);
    }

    /** Enters the mode with the model, and leaves it so. */
    private void follow(PracticeState state) {
        boolean entered = state.topic().isPresent();
        if (entered == isAsking()) {
            if (entered) mode.orElseThrow().refresh();
        } else if (entered) {
            showMode();
            focusPicture();
        } else {
            cards.show(this, LAB);
            lab.focusPicture();
            firePropertyChange(ASKING, true, false);
        }
    }

    @Override
    public boolean isAsking() {
        return mode.filter(PracticePanel::isVisible).isPresent();
    }

    private void showMode() {
        if (mode.isEmpty()) {
            var panel = new PracticePanel(model, language);
            add(panel, MODE);
            mode = Optional.of(panel);
        }
        mode.get().refresh();
        cards.show(this, MODE);
        firePropertyChange(ASKING, false, true);
    }

    @Override
    public void focusPicture() {
        if (isAsking()) mode.get().focusPicture();
        else lab.focusPicture();
    }

    @Override
    public void stop() {
        lab.stop();
    }

    @Override
    public void close() {
        unsubscribe.run();
        lab.close();
    }
}
