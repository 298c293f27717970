package rasterlab.app.model;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.StringReader;
import java.nio.charset.CodingErrorAction;
import java.nio.file.Path;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.TextEncoding;

/** Opens texts of models in whatever encoding they are. */
final class ModelText {
    private ModelText() {}

    /** The encoding that the first bytes of a file tell: UTF-16, else UTF-8 until it is broken. */
    static TextEncoding begun(Path file) throws IOException {
        try (InputStream in = FileToRead.stream(file, FileKind.MODEL)) {
            return TextEncoding.utf16(in.readNBytes(TextEncoding.HEAD)).orElse(TextEncoding.UTF_8);
        }
    }

    /**
     * A large text, decoded as it is read.
     *
     * @return throws a {@link java.nio.charset.CharacterCodingException} where the bytes are none
     *     of UTF-8
     */
    static Reader open(Path file, TextEncoding encoding) throws IOException {
        InputStream in = FileToRead.stream(file, FileKind.MODEL);
        boolean strict = encoding == TextEncoding.UTF_8;
        var decoder =
                encoding.charset()
                        .newDecoder()
                        .onMalformedInput(
                                strict ? CodingErrorAction.REPORT : CodingErrorAction.REPLACE)
                        .onUnmappableCharacter(CodingErrorAction.REPLACE);
        return new BufferedReader(new InputStreamReader(in, decoder));
    }

    /** A text of materials, decoded whole. */
    static Reader materials(Path file) throws IOException {
        try (InputStream in = FileToRead.stream(file, FileKind.MATERIALS)) {
            byte[] bytes = in.readAllBytes();
            return new StringReader(new String(bytes, TextEncoding.of(bytes).charset()));
        }
    }
}
