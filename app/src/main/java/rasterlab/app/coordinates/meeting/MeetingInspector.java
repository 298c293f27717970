package rasterlab.app.coordinates.meeting;

import java.util.function.Consumer;
import javax.swing.JLabel;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.NamedControls;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The method, the plane and the line in numbers, and what every method answers. */
final class MeetingInspector {
    private final MeetingLabModel model;
    private final Texts texts;
    private final Texts explanations;
    private final MeetingReadings readings;
    private final Inspector column;
    private final MethodChooser method;
    private final JLabel normal;
    private final JLabel constant;
    private final JLabel distance;
    private final JLabel from;
    private final JLabel through;
    private final JLabel cosines;
    private final JLabel angle;
    private final JLabel heights;
    private final NumberTable table;
    private final AboutText about;

    /**
     * @param mode adds the row that leads to the other labs
     */
    MeetingInspector(MeetingLabModel model, Texts texts, Consumer<Inspector> mode) {
        this.model = model;
        this.texts = texts;
        explanations = TopicTexts.of("line-plane", texts.language()).texts();
        readings = new MeetingReadings(model, texts);
        column = new Inspector(texts);
        var parts = new NamedControls(column, texts);
        mode.accept(column);
        method = parts.method(model.methods(), model::chooseMethod);
        column.heading("heading.plane");
        normal = column.value("normal");
        constant = column.value("constant");
        distance = column.value("distance");
        column.heading("heading.line");
        from = column.value("from");
        through = column.value("through");
        cosines = column.value("cosines");
        angle = column.value("angle");
        heights = column.value("heights");
        column.heading("heading.answers");
        table = parts.table("heading.answers");
        about = parts.about();
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        method.show(model.choice().method());
        normal.setText(readings.normal());
        constant.setText(readings.constant());
        distance.setText(readings.distance());
        from.setText(readings.from());
        through.setText(readings.through());
        cosines.setText(readings.cosines());
        angle.setText(readings.angle());
        heights.setText(readings.heights());
        table.show(readings.headings(), readings.rows(), readings.chosenRow());
        about.show(explanations, model.method().name(), "", refusal());
    }

    /** Why the method refused: in its own words where those are the window's language. */
    private String refusal() {
        MeetingScene.MeetingAnswer answer = model.scene().chosen();
        if (!answer.refused()) return "";
        return texts.language() == Language.ENGLISH ? answer.refusal() : texts.text("refusal");
    }
}
