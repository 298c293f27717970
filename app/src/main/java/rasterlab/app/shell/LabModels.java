package rasterlab.app.shell;

import rasterlab.app.line.LineLabModel;
import rasterlab.engine.line.LineTopic;

/** The labs' models, which outlive the panels that show them. */
public record LabModels(LineLabModel line) {
    /** Every lab as it opens. */
    public static LabModels first() {
        return new LabModels(new LineLabModel(new LineTopic()));
    }
}
