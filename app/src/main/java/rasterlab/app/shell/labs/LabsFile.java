package rasterlab.app.shell.labs;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.KeptJson;
import rasterlab.app.outcome.TextEncoding;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.shell.settings.BrokenFile;
import rasterlab.app.shell.settings.Problem;
import rasterlab.exercises.json.JsonText;
import rasterlab.exercises.json.NotJson;

/**
 * Keeps the state of every lab between runs in a JSON file beside the window's settings.
 *
 * <p>A lab whose part is missing or broken opens as on the first run, and the others as they were
 * left. What an older version did not keep of a lab yet is as on the first run.
 */
public final class LabsFile {
    private final Path file;
    private final Consumer<Problem> problem;
    private volatile boolean refused;

    /** Whether the file cannot be used and is still there: nothing is written over it. */
    private boolean inTheWay;

    /** Names of the labs whose parts could not be used. */
    private final Set<String> refusedParts = ConcurrentHashMap.newKeySet();

    /** The parts that nothing is written over, since there is no copy. */
    private final Set<String> uncopied = ConcurrentHashMap.newKeySet();

    /**
     * @param problem told, once for every lab, what cannot be kept or brought back
     */
    public LabsFile(Path file, Consumer<Problem> problem) {
        this.file = file;
        this.problem = problem;
    }

    /** The file beside the window's settings. */
    public static LabsFile nextTo(Path settings, Consumer<Problem> problem) {
        return new LabsFile(settings.resolveSibling("labs.json"), problem);
    }

    /** The content of the file, read but not looked into. */
    public static final class Content {
        private final byte[] text;
        private final ObjectNode root;

        private Content(byte[] text, ObjectNode root) {
            this.text = text;
            this.root = root;
        }
    }

    /**
     * The kept state of the labs; empty where nothing is kept or it cannot be read. On any thread.
     */
    public Optional<Content> read() {
        boolean there = Files.exists(file);
        Optional<Content> content = held();
        refused = there && content.isEmpty();
        return content;
    }

    private Content content() throws IOException, NotJson {
        byte[] text = Files.readAllBytes(file);
        Optional<String> obstacle = TextEncoding.obstacle(text);
        if (obstacle.isPresent()) throw new IOException(obstacle.get());
        if (JsonText.tree(new String(text, StandardCharsets.UTF_8)) instanceof ObjectNode root)
            return new Content(text, root);
        throw new IOException("not a JSON object");
    }

    private void setAside(String reason) {
        try {
            Path aside = BrokenFile.setAside(file);
            problem.accept(Problem.of("labs.setAside", file.toString(), reason, aside.toString()));
        } catch (IOException e) {
            if (!inTheWay)
                problem.accept(
                        Problem.of(
                                "labs.inTheWay",
                                file.toString(),
                                reason,
                                file.getFileName().toString(),
                                WholeFile.reason(e)));
            inTheWay = true;
        }
    }

    /**
     * Brings labs to what they showed. On the thread that uses them.
     *
     * @param labs by the names of their parts of the file
     */
    public void restore(Content content, Map<String, Kept<?>> labs) {
        labs.forEach((name, lab) -> restore(name, lab, content));
    }

    /** The choices without those that the file holds no usable part of. */
    Map<String, Object> used(Map<String, Object> choices) {
        if (refused) return Map.of();
        var used = new LinkedHashMap<>(choices);
        used.keySet().removeAll(refusedParts);
        return used;
    }

    private <C> void restore(String name, Kept<C> lab, Content content) {
        JsonNode kept = content.root.path(name);
        if (kept.isMissingNode()) return;
        try {
            JsonNode whole =
                    completed(kept, KeptJson.MAPPER.valueToTree(lab.kept()), lab.keptType());
            lab.restore(KeptJson.MAPPER.treeToValue(whole, lab.keptType()));
        } catch (JsonProcessingException | RuntimeException e) {
            // A file that was changed by hand can miss more than a lab's own checks look at.
            String reason = e instanceof JsonMappingException part ? reasonOf(part) : reason(e);
            refuse(name, reason, content);
        }
    }

    /** Refuses a part, which counts as one to be written over only after its copy is made. */
    private void refuse(String name, String reason, Content content) {
        try {
            String copy = BrokenFile.keep(file, content.text).toString();
            problem.accept(Problem.of("labs.oneNotUsed", file.toString(), name, reason, copy));
        } catch (Complaint noCopy) {
            uncopied.add(name);
            String why = noCopy.getMessage();
            problem.accept(Problem.of("labs.oneInTheWay", file.toString(), name, reason, why));
        }
        refusedParts.add(name);
    }

    /** The kept values, completed by the usual ones where a component of the record is missing. */
    private static JsonNode completed(JsonNode kept, JsonNode usual, Class<?> type) {
        if (!type.isRecord() || !kept.isObject() || !usual.isObject()) return kept;
        ObjectNode whole = KeptJson.MAPPER.createObjectNode().setAll((ObjectNode) kept);
        for (RecordComponent part : type.getRecordComponents()) {
            String name = keptName(part);
            whole.set(
                    name,
                    kept.has(name)
                            ? completed(kept.get(name), usual.path(name), part.getType())
                            : usual.path(name));
        }
        return whole;
    }

    /** The name in the file: an earlier one where the component has been renamed since. */
    private static String keptName(RecordComponent part) {
        JsonProperty kept = part.getAccessor().getAnnotation(JsonProperty.class);
        return kept == null ? part.getName() : kept.value();
    }

    /** The complaint of a part's own check, else the place of the part. */
    private static String reasonOf(JsonMappingException part) {
        if (part.getCause() instanceof IllegalArgumentException refusal) return reason(refusal);
        String path =
                part.getPath().stream()
                        .map(JsonMappingException.Reference::getFieldName)
                        .filter(Objects::nonNull)
                        .collect(Collectors.joining("."));
        return (path.isEmpty() ? "a part of it" : "'" + path + "'")
                + " is missing or not what it should be";
    }

    /**
     * The states of all labs that are made, by the names of their parts of the file. On the event
     * thread.
     */
    public static Map<String, Object> choices(LabModels models) {
        return choices(models.kept());
    }

    /** The states of those labs. On the thread that uses them. */
    static Map<String, Object> choices(Map<String, Kept<?>> labs) {
        var choices = new LinkedHashMap<String, Object>();
        labs.forEach((name, lab) -> choices.put(name, lab.kept()));
        return choices;
    }

    /**
     * Keeps what the labs showed, whole or not at all. On any thread.
     *
     * @param changed names of those that are written over what the file holds, where it can be
     *     read: the others may have been changed by another window
     * @return whether it is kept
     */
    synchronized boolean save(Map<String, Object> choices, Set<String> changed) {
        Optional<Content> held = held();
        if (inTheWay) return false;
        ObjectNode root =
                held.map(content -> content.root).orElseGet(KeptJson.MAPPER::createObjectNode);
        choices.forEach(
                (name, choice) -> {
                    boolean written = changed.contains(name) && !uncopied.contains(name);
                    if (written || !root.has(name))
                        root.set(name, KeptJson.MAPPER.valueToTree(choice));
                });
        try {
            WholeFile.requireFolder(file.toAbsolutePath().getParent());
            WholeFile.write(
                    file, KeptJson.MAPPER.writerWithDefaultPrettyPrinter().writeValueAsBytes(root));
            return true;
        } catch (IOException | Complaint e) {
            problem.accept(Problem.of("labs.notKept", reason(e)));
            return false;
        }
    }

    /** The present content of the file; empty where it cannot be used, and then it is set aside. */
    private synchronized Optional<Content> held() {
        if (Files.exists(file)) {
            try {
                Optional<String> obstacle = FileToRead.obstacle(file, FileKind.SETTINGS);
                if (obstacle.isPresent()) throw new IOException(obstacle.get());
                Content content = content();
                inTheWay = false;
                return Optional.of(content);
            } catch (NotJson e) {
                setAside("not JSON: " + e.phrase());
            } catch (IOException e) {
                setAside(reason(e));
            }
        } else inTheWay = false;
        return Optional.empty();
    }

    private static String reason(Exception e) {
        String message =
                e instanceof JsonProcessingException json ? json.getOriginalMessage() : null;
        if (e instanceof FileSystemException io) message = WholeFile.reason(io);
        if (message == null) message = e.getMessage() == null ? e.toString() : e.getMessage();
        return message.lines().findFirst().orElse(e.toString());
    }
}
