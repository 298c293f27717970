package rasterlab.app.cli;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.FirstDifference;
import rasterlab.app.study.HazardMatrix;
import rasterlab.engine.study.HazardTrial.Cell;

/** The method × hazard table as text. */
final class HazardText {
    private HazardText() {}

    static void print(HazardMatrix matrix, PrintStream out, Texts texts) {
        List<String> heads = new ArrayList<>(List.of(matrix.topic()));
        heads.addAll(matrix.methods());
        var table = new TextTable(heads);
        for (String hazard : matrix.hazards()) {
            List<String> row = new ArrayList<>(List.of(hazard));
            for (String method : matrix.methods()) row.add(marked(matrix.cell(hazard, method)));
            table.add(row);
        }
        table.lines().forEach(out::println);
        matrix.cells().stream()
                .filter(cell -> !cell.asRecorded())
                .map(cell -> difference(cell, texts))
                .forEach(out::println);
    }

    /** The verdict, with "!" where it is not the recorded one. */
    private static String marked(Cell cell) {
        return cell.verdict().kind().code() + (cell.asRecorded() ? "" : " !");
    }

    private static String said(String detail, Language language) {
        Texts words = Texts.of("study", language);
        return Complaints.saidToTypist(language, FirstDifference.said(words, detail));
    }

    private static String difference(Cell cell, Texts texts) {
        String detail = cell.verdict().detail();
        String differs =
                texts.text(
                        "differs",
                        cell.method(),
                        cell.hazard(),
                        cell.verdict().kind().code(),
                        cell.recorded().code());
        return differs + (detail.isEmpty() ? "" : "; " + said(detail, texts.language()));
    }
}
