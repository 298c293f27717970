package rasterlab.app.cli.exercise;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Report;

/**
 * Writes a report's pictures as PNG: CASE-KIND, such as CASE-difference; beside them
 * CASE.scene.json, with which {@code ./lab run --scene} shows what is right.
 */
final class CasePictureFiles {
    private CasePictureFiles() {}

    /**
     * Makes the folder if there is a picture to write.
     *
     * @param language in which their numbers are written, such as "ru"
     * @return the number of files written
     * @throws Complaint if the folder cannot be written to
     */
    static int write(Report report, Path folder, String language) {
        int files = 0;
        for (CaseReport judged : report.cases()) {
            List<CasePicture> pictures = judged.pictures();
            if (pictures.isEmpty()) continue;
            if (files == 0) WholeFile.requireFolder(folder);
            String start = judged.name();
            for (CasePicture one : pictures)
                WholeFile.write(place(folder, judged, one), one.png(language));
            files += pictures.size();
            if (!judged.scene().isEmpty()) {
                byte[] scene = judged.scene().getBytes(StandardCharsets.UTF_8);
                WholeFile.write(folder.resolve(start + SceneText.EXTENSION), scene);
                files++;
            }
        }
        return files;
    }

    /** The file of a case's picture. */
    static Path place(Path folder, CaseReport judged, CasePicture picture) {
        return folder.resolve(judged.name() + "-" + picture.kind() + ".png");
    }
}
