package rasterlab.app.coordinates.list;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JLabel;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/** Which topic's methods there are to choose from, and what the chosen one made of a hazard. */
final class TrialRows {
    /** The topic of the matrices themselves, of which nothing is tried. */
    static final String MATRICES = "matrix";

    private final ListLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser topic;
    private final Map<String, MethodChooser> methods = new LinkedHashMap<>();
    private final JLabel verdict;
    private final JLabel error;
    private final JLabel off;
    private final WrappedText hazard = new WrappedText("trial.hazard");

    TrialRows(ListLabModel model, Texts texts, Inspector column) {
        this.model = model;
        this.texts = texts;
        this.column = column;
        var topics = new ArrayList<>(List.of(MATRICES));
        topics.addAll(model.trials().topics());
        topic = new NameChooser("topic", topics, code -> texts.text("topic." + code), this::choose);
        column.row("topic", topic);
        addMethods(MATRICES, model.methods(), model::chooseMethod);
        for (String each : model.trials().topics())
            addMethods(each, model.trials().methods(each), model::tryMethod);
        verdict = column.value("trial.verdict");
        error = column.value("trial.error");
        off = column.value("trial.off");
        column.wide(hazard);
    }

    private void addMethods(String of, List<? extends Method<?>> all, Consumer<String> chosen) {
        List<String> names = all.stream().map(Method::name).toList();
        var chooser = new MethodChooser("method", "", names, FigureColors.OWN, chosen);
        if (!of.equals(MATRICES)) chooser.withOwn(Texts.of("canvas", texts.language()));
        column.row("method", chooser);
        methods.put(of, chooser);
    }

    private void choose(String code) {
        if (code.equals(MATRICES)) model.endTrial();
        else if (!code.equals(shownTopic())) model.show(model.trials().first(code));
    }

    private String shownTopic() {
        return model.choice().trial().map(Trial::topic).orElse(MATRICES);
    }

    /** Shows the model's present state. */
    void refresh() {
        Optional<Trial> trial = model.choice().trial();
        topic.show(shownTopic());
        methods.forEach((of, chooser) -> column.showRow(chooser, of.equals(shownTopic())));
        methods.get(shownTopic()).show(trial.map(Trial::method).orElse(model.choice().method()));
        for (JLabel each : List.of(verdict, error, off)) column.showRow(each, trial.isPresent());
        hazard.setVisible(trial.isPresent());
        var readings = new TrialReadings(model, texts);
        verdict.setText(readings.verdict());
        error.setText(readings.error());
        error.setToolTipText(readings.unit());
        off.setText(readings.off());
        hazard.show(
                trial.isEmpty()
                        ? ""
                        : texts.text("trial.hazard", readings.hazard(), readings.unit()));
    }

    /** Shows the points and the method of what is tried. */
    void show(NumberTable table, AboutText about) {
        var readings = new TrialReadings(model, texts);
        table.show(readings.headings(), readings.rows(), -1);
        Trial trial = model.choice().trial().orElseThrow();
        Method<?> method = model.trials().method(trial);
        TopicTexts said = TopicTexts.of(trial.topic(), texts.language());
        about.show(said.texts(), method.name(), "", refusal());
    }

    /** The words of the method that refuses the hazard, or the reason why it was stopped. */
    private String refusal() {
        return new TrialReadings(model, texts)
                .known()
                .filter(scene -> isWithoutAnswer(scene))
                .map(
                        scene ->
                                OwnWords.reason(
                                        scene.trial().method(),
                                        scene.verdict().detail(),
                                        texts.language()))
                .orElse("");
    }

    private static boolean isWithoutAnswer(TrialScene scene) {
        boolean own = scene.trial().method().equals(OwnMethods.NAME);
        return own ? scene.made().isEmpty() : scene.verdict().kind() == Verdict.Kind.REFUSED;
    }
}
