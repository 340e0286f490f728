package org.myrobotlab.embedded.web;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.AclEntry;
import java.nio.file.attribute.AclEntryPermission;
import java.nio.file.attribute.AclEntryType;
import java.nio.file.attribute.AclFileAttributeView;
import java.nio.file.attribute.PosixFileAttributeView;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.EnumSet;
import java.util.List;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;

/**
 * What callers must know when the user asked for it with {@code --token}: 192 random bits, new with each start, or what stands in a file of the user.
 * Any thread.
 */
public final class Token {
    /** Characters of the shortest that may be given. */
    public static final int SHORTEST = 16;
    private static final int LONGEST = 200;
    /** Characters of one that nobody guesses, however often. */
    private static final int LONG = 32;
    private static final int BYTES = 24;
    private static final String MAC = "HmacSHA256";
    private static final String OWNER_READS = "rw-------";
    private static final SecureRandom RANDOM = new SecureRandom();
    private static volatile Token current = new Token(null);

    private final String text;
    /** What cookies are made of: of a short token it is no help in guessing that. */
    private final byte[] key;

    private Token(String text) {
        this.text = text;
        this.key = text != null && text.length() >= LONG ? text.getBytes(StandardCharsets.UTF_8) : random();
    }

    private static byte[] random() {
        byte[] bytes = new byte[BYTES];
        RANDOM.nextBytes(bytes);
        return bytes;
    }

    /** A new one: letters, digits, - and _. */
    public static String make() {
        return Base64.getUrlEncoder().withoutPadding().encodeToString(random());
    }

    /** What servers that start now ask for. */
    public static Token current() {
        return current;
    }

    /**
     * From now on servers that start ask for a token.
     *
     * @return that
     */
    public static Token require() {
        current = new Token(make());
        return current;
    }

    /**
     * From now on servers that start ask for the token in a file.
     *
     * @return that
     * @throws IOException if the file can't be read, or others may read it, too
     * @throws IllegalArgumentException if what stands in it is no token
     */
    public static Token require(Path file) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix != null && posix.readAttributes().permissions().stream().anyMatch(one -> !one.name().startsWith("OWNER"))) {
            throw new IOException(file + " is not kept from other users: chmod 600 " + file);
        }
        String text = Files.readString(file).trim();
        if (!text.matches("[\\w.~-]{" + SHORTEST + "," + LONGEST + "}")) {
            throw new IllegalArgumentException(file + " has no token, legal: " + SHORTEST + " to " + LONGEST
                + " letters of English, digits, . _ ~ -");
        }
        current = new Token(text);
        return current;
    }

    /** From now on servers that start ask for none. */
    public static void dismiss() {
        current = new Token(null);
    }

    /** Whether a caller who gave this may call; always if no token is asked for. Takes as long for a wrong one as for the right one. */
    boolean fits(String given) {
        return text == null || isSame(text, given);
    }

    /** Whether two texts are the same, in a time that says nothing of where they differ. */
    static boolean isSame(String right, String given) {
        return MessageDigest.isEqual(right.getBytes(StandardCharsets.UTF_8), given.getBytes(StandardCharsets.UTF_8));
    }

    /** Whether one must be known at all. */
    public boolean isAskedFor() {
        return text != null;
    }

    /** Whether it is so long that nobody guesses it, however often. */
    boolean isLong() {
        return text.length() >= LONG;
    }

    /** What is given to who has shown the token, and tells nothing of it: for something that it is good for, as an address. */
    String cookie(String goodFor) {
        try {
            Mac mac = Mac.getInstance(MAC);
            mac.init(new SecretKeySpec(key, MAC));
            return Base64.getUrlEncoder().withoutPadding().encodeToString(mac.doFinal(goodFor.getBytes(StandardCharsets.UTF_8)));
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException(e);
        }
    }

    /** The token; letters, digits, - and _. */
    public String text() {
        return text;
    }

    /**
     * Writes the token into the file {@code .sear/token-PORT} of the user's home folder, which only that user can read.
     *
     * @return the file
     */
    public Path write(int port) throws IOException {
        Path folder = Files.createDirectories(Paths.get(System.getProperty("user.home"), ".sear"));
        Path file = folder.resolve("token-" + port);
        return writePrivate(file, text + "\n");
    }

    /**
     * Writes a file that only its user can read.
     *
     * @return the file
     */
    public static Path writePrivate(Path file, String content) throws IOException {
        Path part = Files.createTempFile(file.toAbsolutePath().getParent(), "token", null);
        makePrivate(part);
        Files.writeString(part, content);
        return Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void makePrivate(Path file) throws IOException {
        PosixFileAttributeView posix = Files.getFileAttributeView(file, PosixFileAttributeView.class);
        if (posix != null) {
            posix.setPermissions(PosixFilePermissions.fromString(OWNER_READS));
            return;
        }
        AclFileAttributeView acl = Files.getFileAttributeView(file, AclFileAttributeView.class);
        if (acl == null) {
            throw new IOException(file + " can't be kept from other users on this disk: the token is not written");
        }
        acl.setAcl(List.of(AclEntry.newBuilder().setType(AclEntryType.ALLOW).setPrincipal(Files.getOwner(file))
            .setPermissions(EnumSet.allOf(AclEntryPermission.class)).build()));
    }
}
