package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.VisibilityChoice;

/** Reads what the lab tells of a model that it shows. */
class ModelNotesTest {
    @TempDir Path folder;

    @Test
    @DisplayName("what was left out is told by the command only, or in English")
    void notesOfAModelAreTold() throws IOException {
        Path file = folder.resolve("a.obj");
        Files.writeString(
                file, "usemtl B\nv 0 0 0\nv 1 0 0\nv 0 1 0\nfoo\nvn 0 0 0\nbar\nf 1 2 3\n");
        SceneFiles.SceneAnswer answer = SceneFiles.read(file);
        assertEquals("", answer.problem());
        assertEquals("a.obj", answer.change().apply(VisibilityChoice.first()).scene());
        assertEquals(
                file
                        + ":1: there is no material 'B'; the default one stands for it; besides, "
                        + file
                        + ":6: a normal without a direction was passed over; where it is named the"
                        + " face has its own; besides, "
                        + file
                        + ":5: unknown 'foo' was passed over; besides, further notes (1) are told by"
                        + " ./lab render; besides, "
                        + file
                        + ": y is taken to point up; the chooser of the axis turns the model",
                answer.notes());
        String russian = Complaints.translated(Language.RUSSIAN, answer.notes());
        assertTrue(
                russian.endsWith(
                        ":5: неизвестное «foo» пропущено; кроме того, другие примечания (1) сообщает"
                                + " ./lab render; кроме того, "
                                + file
                                + ": осью вверх считается y; другую выбирают в списке «Ось вверх»"),
                russian);
    }

    @Test
    @DisplayName("the note that matters most is cut off, behind those of the file's first lines")
    void whatChangesThePictureIsToldFirst() throws IOException {
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nillum x\nNs x\nKa x\nKd x\nd 0\n");
        Path file = folder.resolve("a.obj");
        Files.writeString(file, "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        String notes = SceneFiles.read(file).notes();
        int all = notes.indexOf("makes all faces transparent altogether");
        int color = notes.indexOf("'Kd' has no number");
        assertTrue(0 <= all && all < color, notes);
        assertTrue(!notes.contains("'illum'") || color < notes.indexOf("'illum'"), notes);
    }
}
