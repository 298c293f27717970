package rasterlab.app.cli.run;

import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Topic;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixTopic;

/** Topic {@code matrix}: {@code name} and its parameters; {@code matrix}, row by row, out. */
final class MatrixRun implements TopicRun {
    private final Topic<MatrixFormula, MatrixCall, double[][]> topic = new MatrixTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    MatrixRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"name":"ROT3DX", "angle":30}, the names being listed below""",
                """
                {"matrix":[[...],...]} row by row, for points as rows""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        if (steps) throw Steps.none(method);
        MatrixCall call = MatrixJson.call(StrictJson.openObject(text, length, MatrixJson.fields()));
        MatrixFormula formula = topic.method(method).implementation();
        double[][] rows = watch.call(method, () -> topic.record(formula, call, 1));
        return json -> {
            json.writeArrayFieldStart("matrix");
            for (double[] row : rows) JsonNumbers.write(json, row);
            json.writeEndArray();
        };
    }
}
