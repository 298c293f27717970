package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class StrayDropTest {
    @ParameterizedTest
    @EnumSource
    @DisplayName("a whole disk is called null")
    void fileIsCalledByItsNameAndARootAsItIs(Language language) {
        Texts texts = Texts.of("shell", language);
        Path root = Path.of("").toAbsolutePath().getRoot();
        String disk = StrayDrop.sentence(texts, root);
        assertTrue(disk.contains(root.toString()), disk);
        String file = StrayDrop.sentence(texts, root.resolve("folder").resolve("a.obj"));
        assertTrue(file.contains("a.obj") && !file.contains("folder"), file);
    }
}
